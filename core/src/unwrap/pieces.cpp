#include "unwrap/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

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
FlatChart pieceAsItLies(const DiskChart& chart, std::vector<double> uv, std::string_view solver) {
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
    out->fallbacks.push_back("before packing cut it: " + note);
  return out;
}

bool isSame(const ChartTopology& a, const ChartTopology& b) {
  return a.triangleCount() == b.triangleCount() && a.surfaceTriangles() == b.surfaceTriangles() &&
         std::equal(a.twin.begin(), a.twin.end(), b.twin.begin());
}

}  // namespace

void moveSame(const ChartSet& from, std::vector<FlatChart>& flatFrom, const ChartSet& to,
              std::vector<FlatChart>& flatTo) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (!flatTo[i].unpacked.empty()) continue;
    const std::uint32_t k = from.ofTriangle[to.triangles(i).front()];
    if (!flatFrom[k].unpacked.empty() && isSame(from.topology(k), to.topology(i)))
      flatTo[i] = std::move(flatFrom[k]);
  }
}

void takePieces(const ChartSet& before, const std::vector<FlatChart>& flatBefore,
                const ChartSet& now, double mostStretch, ThreadPool& pool,
                std::vector<FlatChart>& flat) {
  std::vector<std::array<double, 2>> at(3 * before.ofTriangle.size());  // per corner
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (flatBefore[i].unpacked.empty()) continue;
    const ChartTopology chart = before.topology(i);
    const Indices triangles = before.triangles(i);
    for (std::uint32_t c = 0; c < 3 * chart.surfaceTriangles(); ++c) {
      const double* uv = &flatBefore[i].unpacked[2 * std::size_t{chart.vertexOfCorner[c]}];
      at[3 * std::size_t{triangles[c / 3]} + c % 3] = {uv[0], uv[1]};
    }
  }
  parallelFor(&pool, now.size(), [&](std::size_t i) {
    const Indices triangles = now.triangles(i);
    const FlatChart& whole = flatBefore[before.ofTriangle[triangles.front()]];
    if (!flat[i].unpacked.empty() || whole.unpacked.empty()) return;
    const ChartTopology chart = now.topology(i);
    std::vector<double> uv(2 * std::size_t{chart.vertexCount()});
    for (std::uint32_t c = 0; c < 3 * chart.surfaceTriangles(); ++c) {
      const auto& p = at[3 * std::size_t{triangles[c / 3]} + c % 3];
      uv[2 * std::size_t{chart.vertexOfCorner[c]}] = p[0];
      uv[2 * std::size_t{chart.vertexOfCorner[c]} + 1] = p[1];
    }
    flat[i] = pieceAsItLies(now.chart(i), std::move(uv), whole.solver);
    if (flat[i].unpacked.empty() || flat[i].distortion.symmetricDirichlet > mostStretch) {
      flat[i] = {};
      return;
    }
    flat[i].uncommon = historyOf(whole);
    flat[i].iterations = whole.iterations;
  });
}

std::vector<std::uint8_t> stretchedByCuts(const ChartSet& before,
                                          const std::vector<FlatChart>& flatBefore,
                                          const ChartSet& now, const std::vector<FlatChart>& flat,
                                          double mostStretch) {
  std::vector<std::uint8_t> out(before.size(), 0);
  for (std::size_t i = 0; i < now.size(); ++i) {
    const std::uint32_t whole = before.ofTriangle[now.triangles(i).front()];
    const double bound = std::max(mostStretch, flatBefore[whole].distortion.symmetricDirichlet);
    if (flat[i].distortion.symmetricDirichlet > bound) out[whole] = 1;
  }
  return out;
}

}  // namespace abflat
