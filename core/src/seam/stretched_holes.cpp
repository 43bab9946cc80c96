#include "seam/stretched_holes.h"

#include <algorithm>
#include <map>

namespace abflat {

std::vector<std::uint32_t> stretchedHoles(const SeamMesh& mesh, const CutSurface& s,
                                          const Prediction& prediction,
                                          const std::vector<double>& u, double maxStretch) {
  constexpr double kNearly = 0.8;
  struct Worst {
    std::uint32_t vertex = kNone;
    double shift = 0;
  };
  std::map<std::uint32_t, Worst> ofHole;
  std::vector<double> ofChart(s.charts.size(), 0);
  for (std::uint32_t h = 0; h < mesh.twin.size(); ++h) {
    if (!mesh.isFilling(h / 3)) continue;
    const std::uint32_t v = s.vertexOfCorner[h], c = s.chartOfTriangle[h / 3];
    const double scale = u[s.meshVertex[v]], shift = prediction.shift(c, scale);
    if (s.isBoundary[v] || !(prediction.stretch[c] > maxStretch) ||
        !(prediction.at(c, scale) > maxStretch))
      continue;
    Worst& worst = ofHole[mesh.hole[h / 3]];
    if (worst.vertex == kNone || shift > worst.shift) worst = {v, shift};
    ofChart[c] = std::max(ofChart[c], shift);
  }
  std::vector<std::uint32_t> out;
  for (const auto& [hole, worst] : ofHole)
    if (worst.shift >= kNearly * ofChart[s.chartOfVertex(worst.vertex)])
      out.push_back(worst.vertex);
  return out;
}

}  // namespace abflat
