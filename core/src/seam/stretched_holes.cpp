#include "seam/stretched_holes.h"

#include <algorithm>
#include <map>

namespace abflat {

std::vector<OpenVertex> stretchedHoles(const SeamMesh& mesh, const CutSurface& s,
                                       const Prediction& prediction, const LogScales& u,
                                       double maxStretch) {
  constexpr double kNearly = 0.8;
  struct Worst {
    OpenVertex vertex;
    double shift = 0;
  };
  std::map<HoleId, Worst> ofHole;
  IdVector<CutChartId, double> ofChart(s.charts.size(), 0);
  for (const SurfaceCorner h : mesh.fillingCorners()) {
    const OpenVertex v = s.vertexOfCorner[h];
    const CutChartId c = s.chartOf(h);
    const double scale = u[s.meshVertex[v]], shift = prediction.shift(c, scale);
    if (s.isBoundary[v] || !(prediction.stretch[c] > maxStretch) ||
        !(prediction.at(c, scale) > maxStretch))
      continue;
    Worst& worst = ofHole[mesh.hole[triangleOf(h)]];
    if (!worst.vertex.exists() || shift > worst.shift) worst = {v, shift};
    ofChart[c] = std::max(ofChart[c], shift);
  }
  std::vector<OpenVertex> out;
  for (const auto& [hole, worst] : ofHole)
    if (worst.shift >= kNearly * ofChart[s.chartOf(worst.vertex)]) out.push_back(worst.vertex);
  return out;
}

}  // namespace abflat
