#pragma once

#include <cstdint>
#include <vector>

#include "seam/log_scale.h"
#include "seam/prediction.h"

namespace abflat {

/// A seam from where it ends within a chart to the next junction, and what taking it back costs.
struct SeamTip {
  std::uint32_t chart = 0;
  std::vector<std::uint32_t> edges;  ///< half-edges, from the end on
  std::vector<double> length;        ///< of the first 1, 2, ... of them, by the mesh's cost
  /// Of stretch, for the chart, without them; infinite for more than can be told at once.
  std::vector<double> stretch;

  std::uint32_t vertex(const SeamMesh& mesh) const { return mesh.vertexOfCorner[edges.front()]; }
};

/// What is needed to tell tips of a cut surface.
struct TipSearch {
  const SeamMesh& mesh;
  const Seams& seams;
  const Seams& kept;                           ///< seams that stay
  const std::vector<double>& u;                ///< per vertex of the mesh, as solve() gave it
  const std::vector<std::uint32_t>& outgoing;  ///< see outgoingHalfEdges()
};

/// Per vertex a half-edge from which a counter-clockwise turn passes all round it.
std::vector<std::uint32_t> outgoingHalfEdges(const SeamMesh& mesh);

/// Tips in the charts that are wanted. Costs are those of first order: the log-scale that is freed
/// follows from what holds it at zero now and from Green's function of the plane that is cut along
/// a ray; how much stretch depends on it from one more solution, with the stretch's gradient.
/// `scale` has just solved for `surface`.
std::vector<SeamTip> findTips(const TipSearch& search, const CutSurface& surface,
                              const Prediction& prediction,
                              const std::vector<std::uint8_t>& isWanted, LogScale& scale);

}  // namespace abflat
