#include "mesh/weld_edges.h"

#include <algorithm>
#include <cmath>

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr double kNoLength = 0x1p-40;  // relative to the longest side; a sine of pi is less
constexpr double kUnseen = 0x1p-22;    // four steps of a texcoord in single precision

std::uint32_t firstOf(std::vector<std::uint32_t>& of, std::uint32_t v) {
  while (of[v] != v) v = of[v] = of[of[v]];
  return v;
}

void join(std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t>& of) {
  const auto [first, second] = std::minmax({firstOf(of, a), firstOf(of, b)});
  of[second] = first;
}

/// Points every vertex to the first one that it is joined with.
void settle(Welding& welding) {
  std::vector<std::uint32_t>& of = welding.ofVertex;
  welding.merged = 0;
  for (std::uint32_t v = 0; v < of.size(); ++v) welding.merged += (of[v] = firstOf(of, v)) != v;
}

class EdgeWelder {
 public:
  EdgeWelder(const PolygonMesh& mesh, const Pulse& pulse, Welding& welding)
      : mesh_(mesh), of_(welding.ofVertex), place_(welding.ofVertex) {
    size_.assign(mesh.vertexCount(), HUGE_VAL);
    isSolid_.assign(mesh.vertexCount(), 0);
    for (std::uint32_t f = 0; f < mesh.faceCount() && pulse.beat(); ++f) look(f);
    if (pulse.isStopped()) return;
    for (const std::uint32_t f : faces_) weld(f);
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
               distance(firstOf(of_, a), firstOf(of_, b)) <= kUnseen * size;
      };
      if (sides_[c - begin] <= kNoLength * size || isUnseen()) join(a, b, of_);
    }
  }

  double distance(std::uint32_t a, std::uint32_t b) const {
    return norm(edgeVector(mesh_.positions, a, b));
  }

  const PolygonMesh& mesh_;
  std::vector<std::uint32_t>& of_;
  const std::vector<std::uint32_t> place_;  ///< before
  /// Per place: the longest side of the smallest face, and whether a face keeps an area.
  std::vector<double> size_;
  std::vector<std::uint8_t> isSolid_;
  std::vector<std::uint32_t> faces_;  ///< with short sides
  std::vector<double> sides_;
};

}  // namespace

void joinVertices(const VertexPairs& pairs, Welding& welding) {
  for (const auto& [a, b] : pairs) join(a, b, welding.ofVertex);
  settle(welding);
}

void weldEdges(const PolygonMesh& mesh, const Pulse& pulse, Welding& welding) {
  EdgeWelder(mesh, pulse, welding);
  settle(welding);
}

}  // namespace abflat
