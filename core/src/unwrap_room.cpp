#include "unwrap_room.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "hole/fill_holes.h"
#include "portable_math.h"
#include "seam/piece_fitting.h"

namespace abflat {
namespace {

/// What is wanted of cuts: the most of the logarithm of the texel density, less a share of their
/// length.
struct RoomWish {
  double seamWorth = 0;    ///< of the logarithm, for seams as long as the root of the area
  double utilization = 0;  ///< more is not wanted
};

RoomWish wishOf(const UnwrapOptionValues& options) {
  constexpr double kSeamWorth = 0.08, kMost = 0.92;
  if (options.minUtilization == kAutoMinUtilization) return {kSeamWorth, kMost};
  // Few cells tell a little more or less than packing.
  constexpr double kBarely = 0.005, kMore = 1.02, kMostAsked = 0.96;
  return {kBarely, std::min(kMore * options.minUtilization, kMostAsked)};
}

FlatSurface flatSurface(const ChartSet& set, const std::vector<FlatChart>& flat,
                        const OpenSurface& open) {
  FlatSurface out;
  out.surface = cutAlong(open.mesh, open.seams);
  out.at.resize(out.surface.vertexCount());
  out.canCut.assign(out.surface.charts.size(), 0);
  double area = 0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const ChartTopology chart = set.topology(i);
    const Indices triangles = set.triangles(i);
    out.canCut[out.surface.chartOfTriangle[triangles.front()]] = flat[i].problem.empty();
    area += flat[i].area;
    for (std::uint32_t c = 0; c < 3 * chart.surfaceTriangles(); ++c) {
      const double* uv = &flat[i].unpacked[2 * std::size_t{chart.vertexOfCorner[c]}];
      out.at[out.surface.vertexOfCorner[3 * triangles[c / 3] + c % 3]] = {uv[0], uv[1]};
    }
  }
  out.unitArea = area / open.mesh.totalArea();
  return out;
}

/// Of so many triangles of all charts: what the rest of a run takes is a matter of these.
int mostTries(const OpenSurface& open) {
  constexpr int kLeast = 500, kTrianglesOfTry = 40;
  return kLeast + static_cast<int>(open.mesh.triangleCount() / kTrianglesOfTry);
}

}  // namespace

bool cutsForRoom(const UnwrapOptionValues& options, const std::vector<FlatChart>& flat) {
  return options.minUtilization != 0 && options.texelDensity == kAutoTexelDensity &&
         std::none_of(flat.begin(), flat.end(), [](const FlatChart& c) { return c.isFixed; });
}

RoomCuts findRoomCuts(const ChartSet& set, const std::vector<FlatChart>& flat,
                      const OpenSurface& open, const UnwrapOptionValues& options,
                      double utilization, const std::function<bool()>& goesOn) {
  constexpr std::size_t kMostCharts = 64;
  constexpr double kStep = 0.05, kLeast = 0.02;
  constexpr int kMostSteps = 16;
  const RoomWish wish = wishOf(options);
  RoomCuts out;
  if (set.size() > kMostCharts || !(utilization > 0)) return out;
  const double most = portable::log(wish.utilization / utilization) / 2;
  if (!(most > kLeast)) return out;
  const FlatSurface surface = flatSurface(set, flat, open);
  const QuickFit fit(options.resolution, options.padding, options.rotate);
  PieceFitting uncut(open.mesh, surface, fit);
  const double side = uncut.leastSide();
  if (!(side > 0)) return out;
  const int steps = std::clamp(static_cast<int>(most / kStep), 1, kMostSteps);
  int tries = mostTries(open);
  double best = 0;
  std::unique_ptr<PieceFitting> found;
  const auto attempt = [&](const PieceFitting& from, double gain) {
    auto now = std::make_unique<PieceFitting>(from);
    const double affordable = (gain - best) / wish.seamWorth;
    if (!now->fitInto(side * portable::exp(-gain), affordable, tries)) return;
    const double worth = gain - wish.seamWorth * now->cost();
    if (!(worth > best)) return;
    best = worth;
    found = std::move(now);
  };
  for (int k = 1; k <= steps && tries > 0 && goesOn(); ++k) {
    const double gain = most * k / steps;
    if (found) attempt(*found, gain);
    attempt(uncut, gain);
  }
  if (!found) return out;
  out.halfEdges = found->cuts();
  out.count = found->count();
  out.length = found->length();
  return out;
}

void addCuts(const RoomCuts& cuts, const UnwrapOptionValues& options, OpenSurface& open) {
  open.seams.resize(open.mesh.twin.size(), 0);
  for (const std::uint32_t h : cuts.halfEdges) open.seams[h] = open.seams[open.mesh.twin[h]] = 1;
  openTouchedHoles(open.mesh, cutAlong(open.mesh, open.seams), options.fillHoles, open.seams);
}

bool isWorth(const RoomCuts& cuts, double densityRatio, const UnwrapOptionValues& options) {
  return densityRatio > 1 &&
         portable::log(densityRatio) >
             wishOf(options).seamWorth * PieceFitting::costOf(cuts.count, cuts.length);
}

}  // namespace abflat
