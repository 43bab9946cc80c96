#include "islands/mapped_triangles.h"

#include <algorithm>
#include <cmath>

#include "abflat/pack_layout.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Where the triangles of each island begin, then their number.
std::vector<std::uint32_t> beginOfIslands(const Islands& islands, const Triangulation& all) {
  std::vector<std::uint32_t> begin(islands.count + 1, 0);
  for (const PolygonFace f : all.face)
    if (const std::uint32_t i = islands.ofFace[f]; i != kNoIsland) ++begin[i + 1];
  for (std::uint32_t i = 0; i < islands.count; ++i) begin[i + 1] += begin[i];
  return begin;
}

}  // namespace

MappedTriangles mappedTriangles(const PolygonMesh& mesh, const Islands& islands,
                                const Triangulation& all) {
  MappedTriangles out;
  out.inUv.begin = beginOfIslands(islands, all);
  const std::size_t count = out.inUv.begin.back();
  out.inUv.uv.resize(6 * count);
  out.corners.resize(count);
  out.face.resize(count);
  out.ofMesh.resize(count);
  std::vector<std::uint32_t> next(out.inUv.begin.begin(), out.inUv.begin.end() - 1);
  for (const SurfaceTriangle t : all.face.ids()) {
    const std::uint32_t island = islands.ofFace[all.face[t]];
    if (island == kNoIsland) continue;
    const std::size_t at = next[island]++;
    out.face[at] = all.face[t];
    out.ofMesh[at] = t;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t c = out.corners[at][k] = all.corner[cornerOf(t, k)];
      std::copy_n(&mesh.texcoords[2 * std::size_t{mesh.faceTexcoords[c]}], 2,
                  &out.inUv.uv[6 * at + 2 * k]);
    }
  }
  return out;
}

std::vector<double> surfaceAreas(const PolygonMesh& mesh, const MappedTriangles& triangles,
                                 int exponent) {
  std::vector<double> positions = mesh.positions;
  for (double& x : positions) x = std::ldexp(x, -exponent);
  const IslandTriangles& inUv = triangles.inUv;
  std::vector<double> out(inUv.islands(), 0);
  for (std::uint32_t i = 0; i < inUv.islands(); ++i)
    for (std::uint32_t t = inUv.begin[i]; t < inUv.begin[i + 1]; ++t) {
      const auto& [a, b, c] = triangles.corners[t];
      out[i] +=
          areaOf(positions, {mesh.faceVertices[a], mesh.faceVertices[b], mesh.faceVertices[c]});
    }
  return out;
}

}  // namespace abflat
