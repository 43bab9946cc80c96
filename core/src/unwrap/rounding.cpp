#include "unwrap/rounding.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "base/round_texcoords.h"
#include "boundary/blamed_arc.h"
#include "boundary/move_apart.h"
#include "check/validity.h"
#include "exact/orientation.h"
#include "layout/grid_repair.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Larger charts are not packed again for the sake of one triangle.
constexpr double kMostEnlargedSide = 0.125;
constexpr double kEnlargement = 16;

struct Box {
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};

  double side() const { return std::max(high[0] - low[0], high[1] - low[1]); }
};

Box boxOf(const std::vector<double>& uv) {
  Box out;
  for (std::size_t i = 0; i < uv.size(); ++i) {
    out.low[i % 2] = std::min(out.low[i % 2], uv[i]);
    out.high[i % 2] = std::max(out.high[i % 2], uv[i]);
  }
  return out;
}

/// The step between neighbouring numbers at the largest coordinate, where it is widest.
double stepOf(const std::vector<double>& uv, Numbers numbers) {
  double largest = 1;
  for (const double x : uv) largest = std::max(largest, std::abs(x));
  int exponent = 0;
  if (std::frexp(largest, &exponent) == 0.5) --exponent;
  return std::ldexp(1.0, exponent - (numbers == Numbers::Double ? 52 : 24));
}

std::vector<double> rounded(Numbers numbers, bool isFixed, std::vector<double> uv) {
  if (numbers == Numbers::Double) return uv;
  if (isFixed)
    roundForGltf(uv);
  else
    roundInAtlas(uv);
  return uv;
}

void roundTo(Numbers numbers, FlatChart& chart) {
  chart.uv = rounded(numbers, chart.isFixed, std::move(chart.uv));
}

void placeOne(const Placement& p, FlatChart& flat) {
  const std::vector<double>& from = flat.unpacked;
  flat.uv.resize(from.size());
  for (std::size_t k = 0; k < from.size(); k += 2) {
    flat.uv[k] = p.u(&from[k]) + p.column();
    flat.uv[k + 1] = p.v(&from[k]) + p.row();
  }
}

/// The box after rotating and scaling, but before moving into place, which would cost a tiny chart
/// digits.
Box boxOf(const Placement& placement, const std::vector<double>& unpacked) {
  Placement atOrigin = placement;
  atOrigin.x = atOrigin.y = 0;
  std::vector<double> uv;
  for (std::size_t k = 0; k < unpacked.size(); k += 2)
    uv.insert(uv.end(), {atOrigin.u(&unpacked[k]), atOrigin.v(&unpacked[k])});
  return boxOf(uv);
}

/// Lets a chart that lies within one texel fill it, since nothing else is there. False if the chart
/// is larger.
bool fillTexel(const AtlasSize& resolution, Placement& placement, FlatChart& flat) {
  constexpr double kFree = 0x1p-8;  // of the texel, kept free on each side
  const Box box = boxOf(placement, flat.unpacked);
  const int texels[2] = {resolution.width, resolution.height};
  const double at[2] = {placement.x, placement.y * placement.aspect};
  double corner[2], by = HUGE_VAL;
  for (std::size_t d = 0; d < 2; ++d) {
    const double texel = 1.0 / texels[d], side = box.high[d] - box.low[d];
    if (side >= texel / 2) return false;
    if (side > 0) by = std::min(by, (1 - 2 * kFree) * texel / side);
    corner[d] = std::floor((at[d] + box.low[d]) * texels[d]);
    if (std::floor((at[d] + box.high[d]) * texels[d]) != corner[d]) return false;
  }
  if (!std::isfinite(by)) return false;
  flat.enlarged *= by;
  placement.a *= by;
  placement.b *= by;
  const auto moved = [&](std::size_t d) {
    return (corner[d] + kFree) * (1.0 / texels[d]) - box.low[d] * by;
  };
  placement.x = moved(0);
  placement.y = moved(1) / placement.aspect;
  placeOne(placement, flat);
  return true;
}

/// `exact`: uv before rounding.
bool isRepaired(const DiskChart& chart, Numbers numbers, const std::vector<double>& exact,
                FlatChart& flat) {
  const double step = stepOf(flat.uv, numbers);
  std::vector<double> before = flat.uv;
  if (numbers == Numbers::Double)
    for (double& x : flat.uv) x = std::floor(x / step + 0.5) * step;
  const GridRepair repair = repairOnGrid(chart, exact, step, flat.uv);
  if (repair.isValid) {
    flat.problem.clear();
    checkInPlace(chart, flat);
  }
  if (!repair.isValid || !flat.problem.empty()) {
    flat.uv = std::move(before);
    return false;
  }
  flat.movedVertices = static_cast<std::uint32_t>(repair.moved);
  flat.movedBy = repair.farthest;
  return true;
}

/// Draws parts of the outline back that touch once they are rounded. `exact`: uv before rounding.
bool isDrawnBack(const DiskChart& chart, Numbers numbers, const std::vector<double>& exact,
                 FlatChart& flat) {
  const auto crossings = [&](const std::vector<double>& uv) {
    return findCrossings(boundaryUv(chart, rounded(numbers, flat.isFixed, uv)));
  };
  const std::vector<double> turned = turnedAlong(boundaryAngles(chart, exact));
  const StraightPlaces straight = flat.uncommon ? flat.uncommon->straightPlaces : StraightPlaces();
  constexpr double kFewSteps = 2;
  const MoveLengths lengths{kFewSteps * stepOf(exact, numbers)};
  MovedBack back = moveBack({chart, exact, straight, turned}, lengths, crossings(exact), crossings);
  if (!back.isApart) return false;
  std::vector<double> before = std::move(flat.uv);
  flat.uv = rounded(numbers, flat.isFixed, std::move(back.uv));
  flat.problem.clear();
  checkInPlace(chart, flat);
  if (!flat.problem.empty()) {
    flat.uv = std::move(before);
    return false;
  }
  flat.movedVertices = static_cast<std::uint32_t>(back.moved);
  flat.movedBy = back.farthest;
  return true;
}

std::size_t farthestFrom(const std::vector<double>& uv, std::size_t k) {
  std::size_t best = k;
  double most = 0;
  for (std::size_t i = 0; i < uv.size(); i += 2) {
    const double distance = norm(uv[i] - uv[k], uv[i + 1] - uv[k + 1]);
    if (distance <= most) continue;
    most = distance;
    best = i;
  }
  return best;
}

/// If all points lie in a strip no wider than `thin`, stretches them across the strip to a width of
/// `wide`. False if they do not.
bool widen(double thin, double wide, std::vector<double>& uv) {
  const std::size_t a = farthestFrom(uv, 0), b = farthestFrom(uv, a);
  const double u = uv[b] - uv[a], v = uv[b + 1] - uv[a + 1], length = norm(u, v);
  if (!(length > 0)) return false;
  const double left[2] = {-v / length, u / length};
  std::vector<double> across;
  for (std::size_t i = 0; i < uv.size(); i += 2)
    across.push_back((uv[i] - uv[a]) * left[0] + (uv[i + 1] - uv[a + 1]) * left[1]);
  const auto [low, high] = std::minmax_element(across.begin(), across.end());
  const double thickness = *high - *low, middle = *low + thickness / 2;
  if (!(thickness > 0) || thickness > thin) return false;
  for (std::size_t i = 0; i < uv.size(); ++i)
    uv[i] += left[i % 2] * (across[i / 2] - middle) * (wide / thickness - 1);
  return true;
}

/// Widens a chart that is only a few steps thin as a whole, such as a fan of needles, so that
/// repairing it has room.
bool isRepairedWider(const DiskChart& chart, Numbers numbers, std::vector<double> exact,
                     FlatChart& flat) {
  // In steps. Half of kWide is less than packing leaves free around a chart.
  constexpr double kThin = 12, kWide = 24;
  const double step = stepOf(exact, numbers);
  if (!widen(kThin * step, kWide * step, exact)) return false;
  std::vector<double> before = std::move(flat.uv);
  flat.uv = exact;
  roundTo(numbers, flat);
  if (isRepaired(chart, numbers, exact, flat)) {
    flat.movedVertices = static_cast<std::uint32_t>(flat.uv.size() / 2);
    flat.movedBy += kWide / 2 * step;
    return true;
  }
  flat.uv = std::move(before);
  return false;
}

bool isFine(const DiskChart& chart, Numbers numbers, FlatChart& flat) {
  flat.problem.clear();
  roundTo(numbers, flat);
  checkInPlace(chart, flat);
  return flat.problem.empty();
}

/// Whether a triangle without area on the surface, which may be flat, has become so.
bool isFlattened(const DiskChart& chart, const std::vector<double>& uv) {
  for (const ChartTriangle f : chart.surfaceTriangles()) {
    const auto [a, b, c] = pointsOf(uv, verticesOf(chart.vertexOfCorner, f));
    if (orientation(a, b, c) == 0) return true;
  }
  return false;
}

/// False if the chart has to be larger.
bool fit(const DiskChart& chart, Numbers numbers, const AtlasSize& resolution, bool mayGrow,
         Placement& placement, FlatChart& flat) {
  flat.movedVertices = 0;
  if (!flat.problem.empty()) {
    roundTo(numbers, flat);
    return true;
  }
  std::vector<double> exact = flat.uv;
  const bool isValid = isFine(chart, numbers, flat);
  if (isValid && (flat.isFixed || !isFlattened(chart, flat.uv))) return true;
  if (!flat.isFixed && fillTexel(resolution, placement, flat)) {
    exact = flat.uv;
    if (isFine(chart, numbers, flat)) return true;
  }
  if (isValid && flat.problem.empty()) return true;
  if (flat.isFixed) return true;  // and reports it: its vertices are where they were asked to be
  if (isDrawnBack(chart, numbers, exact, flat)) return true;
  if (isRepaired(chart, numbers, exact, flat)) return true;
  if (isRepairedWider(chart, numbers, exact, flat)) return true;
  const bool isSmall = boxOf(flat.uv).side() * kEnlargement <= kMostEnlargedSide;
  if (!mayGrow || !isSmall) return true;
  flat.enlarged *= kEnlargement;
  flat.problem.clear();
  return false;
}

}  // namespace

void placeInAtlas(const Packing& packing, FlatCharts& flat) {
  for (const ChartId i : flat.ids())
    if (!flat[i].isFixed) placeOne(packing.placements[i], flat[i]);
}

std::size_t roundToSingle(const ChartSet& charts, ThreadPool& pool, FlatCharts& flat) {
  IdVector<ChartId, std::uint8_t> isLost(flat.size(), 0);
  parallelFor(&pool, flat.size(), [&](std::size_t k) {
    const ChartId i(k);
    if (flat[i].isGiven) return;
    flat[i].movedVertices = 0;
    const bool wasValid = flat[i].problem.empty();
    const std::vector<double> exact = flat[i].uv;
    if (flat[i].isFixed)
      abflat::roundToSingle(flat[i].uv);
    else
      roundInAtlas(flat[i].uv);
    const DiskChart chart = charts.chart(i);
    checkInPlace(chart, flat[i]);
    isLost[i] = wasValid && !flat[i].problem.empty() &&
                (flat[i].isFixed || !isDrawnBack(chart, Numbers::Gltf, exact, flat[i]));
  });
  return static_cast<std::size_t>(std::count(isLost.begin(), isLost.end(), 1));
}

std::size_t fitToNumbers(const PackedCharts& packed, Numbers numbers, const AtlasSize& resolution,
                         bool mayGrow) {
  IdVector<ChartId, std::uint8_t> isTooSmall(packed.charts.flat.size(), 0);
  parallelFor(&packed.pool, packed.charts.flat.size(), [&](std::size_t k) {
    const ChartId i(k);
    FlatChart& flat = packed.charts.flat[i];
    if (!flat.isGiven)
      isTooSmall[i] = !fit(packed.charts.set.chart(i), numbers, resolution, mayGrow,
                           packed.packing.placements[i], flat);
  });
  return static_cast<std::size_t>(std::count(isTooSmall.begin(), isTooSmall.end(), 1));
}

std::vector<std::string> fittingNotes(const FlatCharts& flat, Numbers numbers) {
  const std::string precision =
      numbers == Numbers::Double ? "double precision" : "single precision";
  std::size_t larger = 0, charts = 0, vertices = 0;
  double most = 1, farthest = 0;
  for (const FlatChart& chart : flat) {
    larger += chart.enlarged != 1;
    most = std::max(most, chart.enlarged);
    charts += chart.movedVertices > 0;
    vertices += chart.movedVertices;
    farthest = std::max(farthest, chart.movedVertices > 0 ? chart.movedBy : 0);
  }
  std::vector<std::string> out;
  if (larger > 0)
    out.push_back(std::to_string(larger) + (larger == 1 ? " tiny chart is" : " tiny charts are") +
                  " enlarged up to " + withDigits(most, 3) + " times: " + precision +
                  " would lose triangles at the texel density of the other charts");
  if (vertices > 0)
    out.push_back(std::to_string(vertices) + (vertices == 1 ? " vertex" : " vertices") + " of " +
                  std::to_string(charts) + (charts == 1 ? " chart" : " charts") +
                  " moved by up to " + withDigits(farthest, 3) + " in uv, so that rounding to " +
                  precision + " folds nothing");
  return out;
}

}  // namespace abflat
