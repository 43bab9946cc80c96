#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/stable_order.h"
#include "mesh/triangle_geometry.h"
#include "seam/seam_tips.h"
#include "seam/seam_work.h"

namespace abflat {

/// Half-edges around vertices, those of hubs sorted by length, so that near ones are found without
/// going around.
class Stars {
 public:
  explicit Stars(const SeamMesh& mesh) : mesh_(mesh), outgoing_(outgoingHalfEdges(mesh)) {
    constexpr std::uint32_t kMany = 64;
    IdVector<SurfaceVertex, std::uint32_t> degree(mesh.vertexCount(), 0);
    for (const SurfaceCorner h : mesh.corners()) ++degree[mesh.tail(h)];
    hub_.assign(mesh.vertexCount(), kNone);
    for (const SurfaceVertex v : degree.ids()) {
      if (degree[v] < kMany) continue;
      hub_[v] = static_cast<std::uint32_t>(hubs_.size());
      std::vector<Spoke> spokes;
      forEach(v, [&](SurfaceCorner h) { spokes.push_back({edgeLength(h), spokes.size(), h}); });
      sortStably(spokes, [](const Spoke& a, const Spoke& b) {
        return a.length != b.length ? a.length < b.length : a.order < b.order;
      });
      hubs_.push_back(std::move(spokes));
    }
  }

  /// Half-edges that leave a vertex, counter-clockwise.
  template <typename Visit>
  void forEach(SurfaceVertex v, Visit visit) const {
    SurfaceCorner h = outgoing_[v];
    do {
      visit(h);
      h = rotateCounterClockwise(mesh_.twin, h);
    } while (h.exists() && h != outgoing_[v]);
  }

  /// All that are no longer than `most`, and possibly others, in the same order.
  template <typename Visit>
  void forEachNear(SurfaceVertex v, double most, Visit visit) const {
    if (hub_[v] == kNone) return forEach(v, visit);
    const std::vector<Spoke>& spokes = hubs_[hub_[v]];
    const auto end = std::upper_bound(spokes.begin(), spokes.end(), most,
                                      [](double m, const Spoke& s) { return m < s.length; });
    std::vector<Spoke> near(spokes.begin(), end);
    std::sort(near.begin(), near.end(),
              [](const Spoke& a, const Spoke& b) { return a.order < b.order; });
    for (const Spoke& s : near) visit(s.edge);
  }

 private:
  struct Spoke {
    double length;
    std::size_t order;  ///< counter-clockwise
    SurfaceCorner edge;
  };
  double edgeLength(SurfaceCorner h) const {
    return norm(edgeVector(mesh_.positions, mesh_.tail(h), mesh_.head(h)));
  }

  const SeamMesh& mesh_;
  const IdVector<SurfaceVertex, SurfaceCorner> outgoing_;
  IdVector<SurfaceVertex, std::uint32_t> hub_;  ///< index into `hubs_`, or kNone
  std::vector<std::vector<Spoke>> hubs_;
};

}  // namespace abflat
