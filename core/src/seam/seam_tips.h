#pragma once

#include <cstdint>
#include <vector>

#include "seam/log_scale.h"
#include "seam/prediction.h"

namespace abflat {

/// A seam from its end within a chart to the next junction, and the cost of taking it back.
struct SeamTip {
  CutChartId chart;
  std::vector<SurfaceCorner> edges;  ///< starting at the end
  std::vector<double> length;        ///< of the first 1, 2, ... edges, in terms of the mesh's cost
  /// The chart's added stretch without these edges; infinite if they are more than can be predicted
  /// at once.
  std::vector<double> stretch;

  SurfaceVertex vertex(const SeamMesh& mesh) const { return mesh.vertexOfCorner[edges.front()]; }
};

/// What is needed to examine tips of a cut surface.
struct TipSearch {
  const SeamMesh& mesh;
  const Seams& seams;
  const Seams& kept;                                       ///< seams that must stay
  const LogScales& u;                                      ///< as solve() gave it
  const IdVector<SurfaceVertex, SurfaceCorner>& outgoing;  ///< see outgoingHalfEdges()
};

/// Per vertex a half-edge from which a counter-clockwise turn visits all of its surroundings.
IdVector<SurfaceVertex, SurfaceCorner> outgoingHalfEdges(const SeamMesh& mesh);

/// The tips in the wanted charts. Costs are first-order estimates. The log-scale that is freed
/// follows from what holds it at zero now and from Green's function of the plane cut along a ray.
/// How much stretch depends on it follows from one more solution, with the stretch's gradient.
/// `scale` must just have solved for `surface`.
std::vector<SeamTip> findTips(const TipSearch& search, const CutSurface& surface,
                              const Prediction& prediction,
                              const IdVector<CutChartId, std::uint8_t>& isWanted, LogScale& scale);

}  // namespace abflat
