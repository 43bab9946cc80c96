#include "seam/prediction.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/portable_math.h"

namespace abflat {
namespace {

/// e^(2u), clamped where u is so large that it predicts nothing any more.
double areaScale(double u) {
  constexpr double kMost = 8;
  return portable::exp(2 * std::clamp(u, -kMost, kMost));
}

}  // namespace

double Prediction::at(CutChartId chart, double u) const {
  const double ratio = areaScale(u) / meanScale[chart];
  return (ratio + 1 / ratio) / 2;
}

double Prediction::shift(CutChartId chart, double u) const {
  return std::abs(u - portable::log(meanScale[chart]) / 2);
}

double kinkStretch(const SeamMesh& mesh, const CutSurface& s, OpenVertex v) {
  constexpr double kLeastShare = 0.01;
  const SurfaceVertex i = s.meshVertex[v];
  const double ring = 3 * mesh.vertexArea[i];
  if (s.isBoundary[v] || !(ring > kLeastShare * s.charts[s.chartOf(v)].area)) return 0;
  // If angles grow by a factor of 1 + x, singular values differ by about x as well.
  const double x = 2 * kPi / mesh.angleSum[i] - 1;
  return std::min(1.0, x * x / 2);
}

Prediction predictStretch(const SeamMesh& mesh, const CutSurface& s, const LogScales& u) {
  Prediction p;
  const std::size_t charts = s.charts.size();
  IdVector<CutChartId, double> inside(charts, 0), grown(charts, 0), shrunk(charts, 0),
      kinks(charts, 0);
  for (const OpenVertex v : s.vertices()) {
    if (s.isBoundary[v]) continue;
    const SurfaceVertex i = s.meshVertex[v];
    const CutChartId c = s.chartOf(v);
    const double scale = areaScale(u[i]);
    inside[c] += mesh.vertexArea[i];
    kinks[c] += 3 * mesh.vertexArea[i] * kinkStretch(mesh, s, v);
    grown[c] += mesh.vertexArea[i] * scale;
    shrunk[c] += mesh.vertexArea[i] / scale;
  }
  p.stretch.assign(charts, 1);
  p.meanScale.assign(charts, 1);
  p.excess.assign(charts, mesh.excess.empty() ? 1 : 0);
  p.leeway.assign(charts, mesh.front.empty() ? 1 : 0);
  for (const SurfaceTriangle f : mesh.front.ids())
    p.leeway[s.chartOfTriangle[f]] += mesh.area[f] * mesh.leewayAt(f);
  for (const SurfaceTriangle f : mesh.excess.ids())
    p.excess[s.chartOfTriangle[f]] += mesh.area[f] * mesh.excess[f];
  double area = 0, sum = 0;
  for (const CutChartId c : s.charts.ids()) {
    const double all = s.charts[c].area;
    if (all > 0) {
      const double rest = std::max(0.0, all - inside[c]);  // along the boundary, where u = 0
      p.meanScale[c] = (rest + grown[c]) / all;
      if (!mesh.excess.empty()) p.excess[c] /= all;
      const double stretch = (1 + p.meanScale[c] * (rest + shrunk[c]) / all) / 2;
      if (!mesh.front.empty()) p.leeway[c] /= all;
      p.excess[c] /= p.leeway[c];
      p.stretch[c] = 1 + p.excess[c] * (std::max(0.0, stretch - 1) + kinks[c] / all);
    }
    area += all;
    sum += all * (1 + p.leeway[c] * (p.stretch[c] - 1));
  }
  if (area > 0) p.total = sum / area;
  return p;
}

}  // namespace abflat
