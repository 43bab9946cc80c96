#include "islands/find_islands.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "abflat/pack_layout.h"
#include "base/disjoint_sets.h"
#include "base/stable_order.h"

namespace abflat {
namespace {

/// Farther out, areas would be beyond the range of doubles.
constexpr double kMostUv = 1e100;

bool hasTexcoord(const PolygonMesh& mesh, std::uint32_t corner) {
  const std::uint32_t t = mesh.faceTexcoords[corner];
  if (t == kNoTexcoord) return false;
  const double* uv = &mesh.texcoords[2 * std::size_t{t}];
  return std::abs(uv[0]) <= kMostUv && std::abs(uv[1]) <= kMostUv;
}

std::array<double, 5> placeOf(const PolygonMesh& mesh, std::uint32_t corner) {
  const double* xyz = &mesh.positions[3 * std::size_t{mesh.faceVertices[corner]}];
  const double* uv = &mesh.texcoords[2 * std::size_t{mesh.faceTexcoords[corner]}];
  return {xyz[0], xyz[1], xyz[2], uv[0], uv[1]};
}

/// A number per corner, equal for equal positions with equal texcoords.
std::vector<std::uint32_t> numberPlaces(const PolygonMesh& mesh,
                                        std::vector<std::uint32_t> corners) {
  sortStably(corners.data(), corners.data() + corners.size(),
             [&](std::uint32_t a, std::uint32_t b) { return placeOf(mesh, a) < placeOf(mesh, b); });
  std::vector<std::uint32_t> out(mesh.faceVertices.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool isSame = i > 0 && placeOf(mesh, corners[i]) == placeOf(mesh, corners[i - 1]);
    out[corners[i]] = isSame ? out[corners[i - 1]] : corners[i];
  }
  return out;
}

struct FaceEdge {
  std::array<std::uint32_t, 2> ends;  ///< the smaller one first
  std::uint32_t face;
};

}  // namespace

Islands findIslands(const PolygonMesh& mesh) {
  Islands out;
  out.ofFace.assign(mesh.faceCount(), kNoIsland);
  std::vector<std::uint32_t> corners, faces;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
    const std::size_t before = corners.size();
    std::uint32_t c = mesh.faceOffsets[f];
    for (; c < mesh.faceOffsets[f + 1] && hasTexcoord(mesh, c); ++c) corners.push_back(c);
    if (c == mesh.faceOffsets[f + 1])
      faces.push_back(f);
    else
      corners.resize(before);
  }
  const std::vector<std::uint32_t> place = numberPlaces(mesh, std::move(corners));
  std::vector<FaceEdge> edges;
  for (const std::uint32_t f : faces) {
    const std::uint32_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1];
    for (std::uint32_t c = begin; c < end; ++c) {
      const auto [a, b] = std::minmax(place[c], place[c + 1 < end ? c + 1 : begin]);
      if (a != b) edges.push_back({{a, b}, f});
    }
  }
  sortStably(edges, [](const FaceEdge& a, const FaceEdge& b) { return a.ends < b.ends; });
  DisjointSets joined(mesh.faceCount());
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].ends == edges[i - 1].ends) joined.join(edges[i].face, edges[i - 1].face);
  for (const std::uint32_t f : faces) {
    const std::uint32_t first = joined.leastOf(f);
    out.ofFace[f] = first == f ? out.count++ : out.ofFace[first];
  }
  return out;
}

}  // namespace abflat
