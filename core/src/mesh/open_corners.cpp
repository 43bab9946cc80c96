#include "mesh/open_corners.h"

#include <algorithm>

#include "base/stable_order.h"

namespace abflat {
namespace {

/// The corners at some vertices, and which of them share an edge that only two faces have.
class CornersAround {
 public:
  CornersAround(const std::vector<OpenedCorners::Corner>& corners, const PolygonMesh& mesh)
      : mesh_(mesh) {
    std::vector<std::uint8_t> isWanted(mesh.vertexCount(), 0);
    for (const auto& c : corners) isWanted[mesh.faceVertices[c.corner]] = 1;
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
      const std::uint32_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1];
      for (std::uint32_t c = begin; c < end; ++c)
        if (isWanted[mesh.faceVertices[c]])
          around_.push_back({PolygonCorner(c), PolygonCorner(c > begin ? c - 1 : end - 1),
                             PolygonCorner(c + 1 < end ? c + 1 : begin), f, kNone, kNone});
    }
    link();
  }

  struct Around {
    PolygonCorner corner, before, after;
    std::uint32_t face;
    std::uint32_t acrossIn, acrossOut;  ///< the corner beyond its edge, as an index, or kNone
  };

  std::uint32_t indexOf(PolygonCorner c) const {
    const auto found =
        std::lower_bound(around_.begin(), around_.end(), c,
                         [](const Around& a, PolygonCorner wanted) { return a.corner < wanted; });
    return static_cast<std::uint32_t>(found - around_.begin());
  }
  const Around& operator[](std::uint32_t i) const { return around_[i]; }
  std::size_t size() const { return around_.size(); }

 private:
  struct Arm {
    std::uint32_t from, to;
    bool isOut;
    std::uint32_t index;
  };

  void link() {
    std::vector<Arm> arms;
    for (std::uint32_t i = 0; i < around_.size(); ++i) {
      const std::uint32_t v = mesh_.faceVertices[around_[i].corner];
      arms.push_back({v, mesh_.faceVertices[around_[i].before], false, i});
      arms.push_back({v, mesh_.faceVertices[around_[i].after], true, i});
    }
    sortStably(arms, [](const Arm& a, const Arm& b) {
      if (a.from != b.from) return a.from < b.from;
      if (a.to != b.to) return a.to < b.to;
      return a.isOut != b.isOut ? a.isOut : a.index < b.index;
    });
    for (std::size_t i = 0, end = 0; i < arms.size(); i = end) {
      while (end < arms.size() && arms[end].from == arms[i].from && arms[end].to == arms[i].to)
        ++end;
      if (end - i != 2 || !arms[i].isOut || arms[i + 1].isOut) continue;
      around_[arms[i].index].acrossOut = arms[i + 1].index;
      around_[arms[i + 1].index].acrossIn = arms[i].index;
    }
  }

  const PolygonMesh& mesh_;
  std::vector<Around> around_;
};

}  // namespace

void openCorners(const OpenedCorners& opened, PolygonMesh& mesh) {
  if (opened.corners.empty()) return;
  const CornersAround around(opened.corners, mesh);
  std::vector<std::uint32_t> vertex(around.size(), kNone);  // the new ones
  std::vector<std::uint8_t> isOpened(around.size(), 0);
  for (const auto& [corner, point] : opened.corners) isOpened[around.indexOf(corner)] = 1;
  const auto first = static_cast<std::uint32_t>(mesh.vertexCount());
  for (const auto& [corner, point] : opened.corners) {
    if (point == kNone) continue;
    const std::uint32_t i = around.indexOf(corner);
    vertex[i] = first + point;
    for (const auto across : {&CornersAround::Around::acrossIn, &CornersAround::Around::acrossOut})
      for (std::uint32_t k = around[i].*across; k != kNone && !isOpened[k] && vertex[k] == kNone;
           k = around[k].*across)
        vertex[k] = vertex[i];
  }
  for (std::uint32_t i = 0; i < around.size(); ++i)
    if (vertex[i] != kNone) mesh.faceVertices[around[i].corner] = vertex[i];
  mesh.positions.insert(mesh.positions.end(), opened.positions.begin(), opened.positions.end());
}

}  // namespace abflat
