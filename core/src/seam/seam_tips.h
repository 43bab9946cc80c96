#pragma once

#include <cstdint>
#include <vector>

#include "seam/log_scale.h"
#include "seam/prediction.h"

namespace abflat {

/// A seam from where it ends within a chart to the next junction, and what taking it back costs.
struct SeamTip {
  CutChartId chart;
  std::vector<SurfaceCorner> edges;  ///< from the end on
  std::vector<double> length;        ///< of the first 1, 2, ... of them, by the mesh's cost
  /// Of stretch, for the chart, without them; infinite for more than can be told at once.
  std::vector<double> stretch;

  SurfaceVertex vertex(const SeamMesh& mesh) const { return mesh.vertexOfCorner[edges.front()]; }
};

/// What is needed to tell tips of a cut surface.
struct TipSearch {
  const SeamMesh& mesh;
  const Seams& seams;
  const Seams& kept;                                       ///< seams that stay
  const LogScales& u;                                      ///< as solve() gave it
  const IdVector<SurfaceVertex, SurfaceCorner>& outgoing;  ///< see outgoingHalfEdges()
};

/// Per vertex a half-edge from which a counter-clockwise turn passes all round it.
IdVector<SurfaceVertex, SurfaceCorner> outgoingHalfEdges(const SeamMesh& mesh);

/// Tips in the charts that are wanted. Costs are those of first order: the log-scale that is freed
/// follows from what holds it at zero now and from Green's function of the plane that is cut along
/// a ray; how much stretch depends on it from one more solution, with the stretch's gradient.
/// `scale` has just solved for `surface`.
std::vector<SeamTip> findTips(const TipSearch& search, const CutSurface& surface,
                              const Prediction& prediction,
                              const IdVector<CutChartId, std::uint8_t>& isWanted, LogScale& scale);

}  // namespace abflat
