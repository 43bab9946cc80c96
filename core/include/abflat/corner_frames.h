#pragma once

#include <cstdint>
#include <vector>

#include "abflat/export.h"

// What normal maps need of a mesh whose layout changes, as BakeTriangles lists it. A triangle
// begins at the same corner before and after; where it was turned, or is mirrored, its other
// corners swap places.

namespace abflat {

/// Triangles in order that have tangents of their own, such as a primitive of a glTF.
struct FramePart {
  std::uint32_t firstFace = 0, faceCount = 0;
  bool isMirrored = false;   ///< corners 1 and 2 are the other way round than they are drawn
  bool hasTangents = false;  ///< those of its vertices count
};

/// A mesh in the caller's memory.
struct FrameMesh {
  const std::vector<std::uint32_t>& corners;  ///< vertices, three to a triangle, before turning
  const std::vector<bool>& isTurned;          ///< per triangle
  const std::vector<double>& positions;       ///< 3 per vertex
  const std::vector<float>& normals;   ///< 3 per vertex of any length; all 0 if there is none
  const std::vector<float>& tangents;  ///< 4 per vertex, in parts that have them
  std::vector<FramePart> parts;        ///< of all triangles, in order

  std::size_t faces() const { return corners.size() / 3; }
  /// Vertex of a corner of the turned triangle.
  std::uint32_t vertex(std::size_t face, std::size_t corner) const;
};

/// 3 numbers per corner, of length 1: those of the vertices, or across the triangle.
ABFLAT_API std::vector<float> cornerNormals(const FrameMesh& mesh);

/// 4 numbers per corner: the given tangents, or else those of MikkTSpace for uv (v downwards) of
/// each part for itself, with its triangles as they were drawn.
ABFLAT_API std::vector<float> oldTangents(const FrameMesh& mesh, const std::vector<double>& oldUv,
                                          const std::vector<float>& normals);

/// The same in the new layout, with triangles as they are drawn now; given tangents do not count.
ABFLAT_API std::vector<float> newTangents(const FrameMesh& mesh, const std::vector<double>& uv,
                                          const std::vector<float>& normals);

}  // namespace abflat
