#include "unwrap/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/point2.h"
#include "check/distortion.h"
#include "check/validity.h"
#include "mesh/triangle_geometry.h"
#include "unwrap/stretch.h"

namespace abflat {
namespace {

/// `uv` is in the mesh's unit.
FlatChart pieceAsItLies(const DiskChart& chart, std::vector<double> uv, Solver solver) {
  FlatChart out;
  out.area = areaOf(chart);
  if (!scaleToSurface(chart, uv)) return {};
  out.unpacked = uv;
  for (double& x : uv) x /= chart.unit;
  if (!checkSeparated(chart, uv).valid()) return {};
  out.solver = solver;
  out.distortion = ChartDistortion(measureDistortion(chart, uv));
  return out;
}

/// What the whole chart went through before it was cut, shared by its pieces.
std::unique_ptr<UncommonParts> historyOf(const FlatChart& whole) {
  if (!whole.uncommon) return nullptr;
  auto out = std::make_unique<UncommonParts>();
  out->refined = whole.uncommon->refined;
  for (const std::string& note : whole.uncommon->fallbacks)
    out->fallbacks.push_back("before the chart was cut: " + note);
  return out;
}

bool isSame(const ChartTopology& a, const ChartTopology& b) {
  return a.triangleCount() == b.triangleCount() &&
         std::equal(a.triangles.begin(), a.triangles.end(), b.triangles.begin(),
                    b.triangles.end()) &&
         std::equal(a.twin.begin(), a.twin.end(), b.twin.begin());
}

}  // namespace

void moveSame(LaidCharts& from, LaidCharts& to) {
  for (const ChartId i : to.set.ids()) {
    if (!to.flat[i].unpacked.empty()) continue;
    const ChartTopology chart = to.set.topology(i);
    const ChartId k = from.set.ofTriangle[chart.triangles.front()];
    if (!from.flat[k].unpacked.empty() && isSame(from.set.topology(k), chart))
      to.flat[i] = std::move(from.flat[k]);
  }
}

void takePieces(const LaidCharts& before, const UnwrapOptionValues& options, ThreadPool& pool,
                LaidCharts& now) {
  IdVector<SurfaceCorner, Point2> at(3 * before.set.ofTriangle.size());
  for (const ChartId i : before.set.ids()) {
    if (before.flat[i].unpacked.empty()) continue;
    const ChartTopology chart = before.set.topology(i);
    for (const ChartCorner c : chart.surfaceCorners())
      at[chart.onSurface(c)] = pointAt(before.flat[i].unpacked, chart.vertexOfCorner[c]);
  }
  parallelFor(&pool, now.set.size(), [&](std::size_t k) {
    const ChartId i(k);
    const ChartTopology chart = now.set.topology(i);
    FlatChart& piece = now.flat[i];
    const FlatChart& whole = before.flat[before.set.ofTriangle[chart.triangles.front()]];
    if (!piece.unpacked.empty() || whole.unpacked.empty()) return;
    std::vector<double> uv(2 * chart.vertexCount());
    for (const ChartCorner c : chart.surfaceCorners())
      setPoint(uv, chart.vertexOfCorner[c], at[chart.onSurface(c)]);
    piece = pieceAsItLies(now.set.chart(i), std::move(uv), whole.solver);
    if (piece.unpacked.empty() || isStretched(piece, now.set.leewayOf(i), options)) {
      piece = {};
      return;
    }
    piece.uncommon = historyOf(whole);
    piece.iterations = whole.iterations;
  });
}

IdVector<ChartId, std::uint8_t> stretchedByCuts(const LaidCharts& before, const LaidCharts& now,
                                                const UnwrapOptionValues& options) {
  IdVector<ChartId, std::uint8_t> out(before.set.size(), 0);
  for (const ChartId i : now.set.ids()) {
    const ChartId whole = before.set.ofTriangle[now.set.topology(i).triangles.front()];
    const double bound =
        std::max(options.maxStretch,
                 stretchOf(before.flat[whole].distortion, before.set.leewayOf(whole), options));
    if (stretchOf(now.flat[i].distortion, now.set.leewayOf(i), options) > bound) out[whole] = 1;
  }
  return out;
}

}  // namespace abflat
