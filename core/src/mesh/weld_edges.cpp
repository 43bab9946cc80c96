#include "mesh/weld_edges.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/disjoint_sets.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr double kNoLength = 0x1p-40;  // relative to the longest side; a sine of pi is less
constexpr double kUnseen = 0x1p-22;    // four steps of a texcoord in single precision

class EdgeWelder {
 public:
  EdgeWelder(const PolygonMesh& mesh, const std::vector<std::uint32_t>& place)
      : mesh_(mesh),
        place_(place),
        sets_(place),
        size_(mesh.vertexCount(), HUGE_VAL),
        isSolid_(mesh.vertexCount(), 0) {}

  /// The first one of the merged vertices, per vertex.
  std::vector<std::uint32_t> weld(const Listener& listener) && {
    for (std::uint32_t f = 0; f < mesh_.faceCount() && listener.beat(); ++f) look(f);
    if (!listener.isStopped())
      for (const std::uint32_t f : faces_) weld(f);
    return std::move(sets_).release();
  }

 private:
  /// Measures the sides of a face; returns the longest.
  double measure(std::uint32_t f) {
    sides_.clear();
    const std::uint32_t begin = mesh_.faceOffsets[f], end = mesh_.faceOffsets[f + 1];
    for (std::uint32_t c = begin; c < end; ++c) {
      const std::uint32_t next = c + 1 < end ? c + 1 : begin;
      sides_.push_back(distance(mesh_.faceVertices[c], mesh_.faceVertices[next]));
    }
    return *std::max_element(sides_.begin(), sides_.end());
  }

  void look(std::uint32_t f) {
    const double longest = measure(f);
    const auto isShort = [&](double side) { return side <= kUnseen * longest; };
    const auto shorter = std::count_if(sides_.begin(), sides_.end(), isShort);
    const bool isSolid = static_cast<std::size_t>(shorter) + 3 <= sides_.size();
    if (shorter > 0) faces_.push_back(f);
    for (std::uint32_t c = mesh_.faceOffsets[f]; c < mesh_.faceOffsets[f + 1]; ++c) {
      const std::uint32_t v = place_[mesh_.faceVertices[c]];
      size_[v] = std::min(size_[v], longest);
      if (isSolid) isSolid_[v] = 1;
    }
  }

  void weld(std::uint32_t f) {
    measure(f);
    const std::uint32_t begin = mesh_.faceOffsets[f], end = mesh_.faceOffsets[f + 1];
    for (std::uint32_t c = begin; c < end; ++c) {
      const std::uint32_t a = place_[mesh_.faceVertices[c]];
      const std::uint32_t b = place_[mesh_.faceVertices[c + 1 < end ? c + 1 : begin]];
      const double size = std::min(size_[a], size_[b]);
      const auto isUnseen = [&] {
        return sides_[c - begin] <= kUnseen * size && isSolid_[a] && isSolid_[b] &&
               distance(sets_.leastOf(a), sets_.leastOf(b)) <= kUnseen * size;
      };
      if (sides_[c - begin] <= kNoLength * size || isUnseen()) sets_.join(a, b);
    }
  }

  double distance(std::uint32_t a, std::uint32_t b) const {
    return norm(edgeVector(mesh_.positions, a, b));
  }

  const PolygonMesh& mesh_;
  const std::vector<std::uint32_t>& place_;  ///< before
  DisjointSets sets_;
  /// Per place: the longest side of the smallest face, and whether a face keeps an area.
  std::vector<double> size_;
  std::vector<std::uint8_t> isSolid_;
  std::vector<std::uint32_t> faces_;  ///< with short sides
  std::vector<double> sides_;
};

}  // namespace

std::vector<std::uint32_t> joinVertices(const VertexPairs& pairs,
                                        std::vector<std::uint32_t> place) {
  DisjointSets sets(std::move(place));
  for (const auto& [a, b] : pairs) sets.join(a, b);
  return std::move(sets).release();
}

std::vector<std::uint32_t> weldEdges(const PolygonMesh& mesh, const Listener& listener,
                                     const std::vector<std::uint32_t>& place) {
  return EdgeWelder(mesh, place).weld(listener);
}

}  // namespace abflat
