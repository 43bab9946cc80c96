#include "unwrap/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/point2.h"
#include "check/distortion.h"
#include "check/validity.h"

namespace abflat {
namespace {

double signedArea(const DiskChart& chart, const std::vector<double>& uv) {
  double twice = 0;
  for (std::uint32_t f = 0; f < chart.surfaceTriangles(); ++f) {
    const double* p[3];
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = &uv[2 * std::size_t{chart.vertexOfCorner[3 * f + k]}];
    twice += (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
  }
  return twice / 2;
}

/// `uv` in the mesh's unit.
FlatChart pieceAsItLies(const DiskChart& chart, std::vector<double> uv, Solver solver) {
  FlatChart out;
  out.area = areaOf(chart);
  const double factor = std::sqrt(out.area / signedArea(chart, uv));
  if (!std::isfinite(factor)) return {};
  for (double& x : uv) x *= factor;
  out.unpacked = uv;
  for (double& x : uv) x /= chart.unit;
  if (!checkSeparated(chart, uv).valid()) return {};
  out.solver = solver;
  out.distortion = ChartDistortion(measureDistortion(chart, uv));
  return out;
}

/// What its chart went through before, which a piece shares.
std::unique_ptr<UncommonParts> historyOf(const FlatChart& whole) {
  if (!whole.uncommon) return nullptr;
  auto out = std::make_unique<UncommonParts>();
  out->refined = whole.uncommon->refined;
  for (const std::string& note : whole.uncommon->fallbacks)
    out->fallbacks.push_back("before the packing cut: " + note);
  return out;
}

bool isSame(const ChartTopology& a, const ChartTopology& b) {
  return a.triangleCount() == b.triangleCount() && a.triangles.size() == b.triangles.size() &&
         std::equal(a.twin.begin(), a.twin.end(), b.twin.begin());
}

}  // namespace

void moveSame(const ChartSet& from, FlatCharts& flatFrom, const ChartSet& to, FlatCharts& flatTo) {
  for (const ChartId i : to.ids()) {
    if (!flatTo[i].unpacked.empty()) continue;
    const ChartId k = from.ofTriangle[to.topology(i).triangles.front()];
    if (!flatFrom[k].unpacked.empty() && isSame(from.topology(k), to.topology(i)))
      flatTo[i] = std::move(flatFrom[k]);
  }
}

void takePieces(const ChartSet& before, const FlatCharts& flatBefore, const ChartSet& now,
                double mostStretch, ThreadPool& pool, FlatCharts& flat) {
  IdVector<SurfaceCorner, Point2> at(3 * before.ofTriangle.size());
  for (const ChartId i : before.ids()) {
    if (flatBefore[i].unpacked.empty()) continue;
    const ChartTopology chart = before.topology(i);
    for (const ChartCorner c : chart.surfaceCorners())
      at[chart.onSurface(c)] = pointAt(flatBefore[i].unpacked, chart.vertexOfCorner[c]);
  }
  parallelFor(&pool, now.size(), [&](std::size_t k) {
    const ChartId i(k);
    const ChartTopology chart = now.topology(i);
    const FlatChart& whole = flatBefore[before.ofTriangle[chart.triangles.front()]];
    if (!flat[i].unpacked.empty() || whole.unpacked.empty()) return;
    std::vector<double> uv(2 * chart.vertexCount());
    for (const ChartCorner c : chart.surfaceCorners())
      setPoint(uv, chart.vertexOfCorner[c], at[chart.onSurface(c)]);
    flat[i] = pieceAsItLies(now.chart(i), std::move(uv), whole.solver);
    if (flat[i].unpacked.empty() || flat[i].distortion.symmetricDirichlet > mostStretch) {
      flat[i] = {};
      return;
    }
    flat[i].uncommon = historyOf(whole);
    flat[i].iterations = whole.iterations;
  });
}

IdVector<ChartId, std::uint8_t> stretchedByCuts(const ChartSet& before,
                                                const FlatCharts& flatBefore, const ChartSet& now,
                                                const FlatCharts& flat, double mostStretch) {
  IdVector<ChartId, std::uint8_t> out(before.size(), 0);
  for (const ChartId i : now.ids()) {
    const ChartId whole = before.ofTriangle[now.topology(i).triangles.front()];
    const double bound = std::max(mostStretch, flatBefore[whole].distortion.symmetricDirichlet);
    if (flat[i].distortion.symmetricDirichlet > bound) out[whole] = 1;
  }
  return out;
}

}  // namespace abflat
