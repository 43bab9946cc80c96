#pragma once

#include <array>
#include <vector>

#include "base/ids.h"

namespace abflat {

/// Numbers of the user's mesh. Welding keeps the numbers of vertices, and adds some.
using InputVertex = Id<struct InputVertexTag>;
using InputFace = Id<struct InputFaceTag>;
using InputCorner = Id<struct InputCornerTag>;  ///< index into PolygonMesh::faceVertices

/// Numbers of the polygons that are triangulated: the welded mesh's, or the input's if nothing is
/// welded.
using PolygonFace = Id<struct PolygonFaceTag>;
using PolygonCorner = Id<struct PolygonCornerTag>;

/// Numbers of a surface made of triangles. A corner is also the half-edge that leaves it.
using SurfaceVertex = Id<struct SurfaceVertexTag>;
using SurfaceTriangle = Id<struct SurfaceTriangleTag>;
using SurfaceCorner = Id<struct SurfaceCornerTag>;

/// Numbers within one chart.
using ChartVertex = Id<struct ChartVertexTag>;
using ChartTriangle = Id<struct ChartTriangleTag>;
using ChartCorner = Id<struct ChartCornerTag>;

/// Position of a half-edge along a chart's boundary loop.
using BoundaryIndex = Id<struct BoundaryTag>;

/// The triangle and vertex types that belong to a corner type.
template <class Corner>
struct CornerTraits;
template <>
struct CornerTraits<SurfaceCorner> {
  using Triangle = SurfaceTriangle;
};
template <>
struct CornerTraits<ChartCorner> {
  using Triangle = ChartTriangle;
};
template <class Triangle>
struct TriangleTraits;
template <>
struct TriangleTraits<SurfaceTriangle> {
  using Corner = SurfaceCorner;
};
template <>
struct TriangleTraits<ChartTriangle> {
  using Corner = ChartCorner;
};

/// Corner c = 3f + k of triangle f; half-edge h = 3f + k runs from the vertex of corner h to that
/// of nextCorner(h).
template <class Corner>
constexpr Corner nextCorner(Corner c) {
  return Corner(c % 3 == 2 ? c - 2 : c + 1);
}
template <class Corner>
constexpr Corner prevCorner(Corner c) {
  return Corner(c % 3 == 0 ? c + 2 : c - 1);
}
template <class Corner>
constexpr typename CornerTraits<Corner>::Triangle triangleOf(Corner c) {
  return typename CornerTraits<Corner>::Triangle(c / 3);
}
/// Which corner of its triangle it is, 0 to 2.
template <class Tag>
constexpr std::size_t placeInTriangle(Id<Tag> c) {
  return c % 3;
}
template <class Triangle>
constexpr typename TriangleTraits<Triangle>::Corner cornerOf(Triangle f, std::size_t k) {
  return typename TriangleTraits<Triangle>::Corner(3 * f + k);
}
template <class Triangle>
constexpr IdRange<typename TriangleTraits<Triangle>::Corner> cornersOf(Triangle f) {
  return {cornerOf(f, 0), cornerOf(f, 3)};
}

/// The three vertices of a triangle as plain numbers, for geometry.
using TriangleVertices = std::array<std::uint32_t, 3>;
template <class Corner, class Vertex>
TriangleVertices verticesOf(const IdVector<Corner, Vertex>& vertexOfCorner,
                            typename CornerTraits<Corner>::Triangle f) {
  return {vertexOfCorner[cornerOf(f, 0)], vertexOfCorner[cornerOf(f, 1)],
          vertexOfCorner[cornerOf(f, 2)]};
}

/// The next half-edge in clockwise order that leaves the same vertex; none if the boundary is in
/// between.
template <class Corner>
Corner rotateClockwise(const IdVector<Corner, Corner>& twin, Corner h) {
  return twin[h].exists() ? nextCorner(twin[h]) : Corner();
}
/// The same in counter-clockwise order.
template <class Corner>
Corner rotateCounterClockwise(const IdVector<Corner, Corner>& twin, Corner h) {
  return twin[prevCorner(h)];
}

/// The same for plain numbers.
inline std::uint32_t rotateClockwise(const std::vector<std::uint32_t>& twin, std::uint32_t h) {
  return twin[h] == kNone ? kNone : nextCorner(twin[h]);
}
inline std::uint32_t rotateCounterClockwise(const std::vector<std::uint32_t>& twin,
                                            std::uint32_t h) {
  return twin[prevCorner(h)];
}

}  // namespace abflat
