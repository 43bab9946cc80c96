#include "unwrap/utilization_note.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "base/point2.h"

namespace abflat {
namespace {

/// From this share of a tile's side on, something reaches across it.
constexpr double kSpan = 0.9;

double distance(const Point2& a, const Point2& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
}

/// What the charts look like in the atlas.
struct Occupants {
  bool isAnyLong = false;  ///< a chart reaches across the tile, but is far longer than wide
  double longestEdge = 0;
  SurfaceTriangle triangle;  ///< a triangle at that edge
  double perimeter = 0;      ///< of all charts
};

/// Lengths are in longer sides of the tile.
void addChart(const ChartTopology& chart, const std::vector<double>& uv, const AtlasSize& size,
              Occupants& out) {
  constexpr double kLong = 12;  // times as long as wide
  const double sides[2] = {static_cast<double>(size.width) / size.longer(),
                           static_cast<double>(size.height) / size.longer()};
  const auto at = [&](ChartCorner h) {
    const auto [u, v] = pointAt(uv, chart.vertexOfCorner[h]);
    return Point2{u * sides[0], v * sides[1]};
  };
  double twiceArea = 0;
  Point2 low = at(ChartCorner(0)), high = low;
  for (const ChartCorner h : chart.surfaceCorners()) {
    const Point2 a = at(h), b = at(nextCorner(h));
    twiceArea += a[0] * b[1] - a[1] * b[0];
    for (std::size_t d = 0; d < 2; ++d) {
      low[d] = std::min(low[d], a[d]);
      high[d] = std::max(high[d], a[d]);
    }
    const double length = distance(a, b);
    if (chart.twin[h] >= chart.surfaceCorners().size()) out.perimeter += length;
    if (length <= out.longestEdge) continue;
    out.longestEdge = length;
    out.triangle = triangleOf(chart.onSurface(h));
  }
  const double reach = distance(low, high);
  out.isAnyLong = out.isAnyLong || (reach > kSpan && reach * reach > kLong * twiceArea / 2);
}

Occupants occupantsOf(const LaidCharts& charts, const AtlasSize& size) {
  Occupants out;
  for (const ChartId i : charts.set.ids())
    addChart(charts.set.topology(i), charts.flat[i].uv, size, out);
  return out;
}

/// The option that keeps charts from being cut; empty if none does.
std::string obstacle(const UnwrapOptions& options, const FlatCharts& flat, CutMode mode) {
  if (options.texelDensity != kAutoTexelDensity) return "the texel density is given";
  if (std::any_of(flat.begin(), flat.end(), [](const FlatChart& c) { return c.isFixed; }))
    return "no chart is cut for packing beside charts that are pinned or kept";
  if (!options.seams.isAuto) return "charts are cut for packing only if seams are automatic";
  if (options.t != kAutoT) return "charts are cut for packing only if t is auto";
  return mode == CutMode::None ? "so many charts are not cut for packing" : "";
}

std::string reason(const Occupants& occupants, CutMode mode, const FlatCharts& flat,
                   const SurfaceMap& map, const UnwrapOptions& options) {
  constexpr double kMuchPadding = 0.05;  // of the tile
  if (std::string text = obstacle(options, flat, mode); !text.empty()) return text;
  if (occupants.longestEdge > kSpan)
    return "face " + std::to_string(map.face(occupants.triangle)) +
           " is as long as the tile, and charts are cut only along edges. Subdivide it";
  if (options.minUtilization == kAutoMinUtilization)
    return "cutting long charts further would take too many seams. A minUtilization of 0.7, for "
           "example, cuts them";
  if (options.straightSeams)
    return "with straight seams, only charts far longer than wide are cut for packing";
  if (mode == CutMode::Long)
    return "of so many charts, only those far longer than wide are cut for packing";
  const bool isPadded =
      occupants.perimeter * options.padding / 2 / options.resolution.shorter() > kMuchPadding;
  return std::string("no further cut that was tried helps") +
         (isPadded ? ". A higher resolution or less padding leaves less between charts" : "");
}

std::string percent(double share, int digits) { return withDigits(100 * share, digits) + " %"; }

std::string shareText(double reached, double asked) {
  if (asked == kAutoMinUtilization) return percent(reached, 2) + " of the tile";
  int digits = 2;
  while (digits < 6 && percent(reached, digits) == percent(asked, digits)) ++digits;
  return percent(reached, digits) + " of the tile, not the " + percent(asked, digits) +
         " asked for";
}

}  // namespace

std::string utilizationNote(const PackedCharts& packed, const SurfaceMap& map,
                            const UnwrapOptions& options, const AtlasReport& atlas) {
  constexpr double kPoor = 0.25;
  if (options.packingCuts == PackingCuts::Never) return {};
  const LaidCharts& charts = packed.charts;
  const double asked = options.minUtilization, reached = atlas.utilization;
  const bool isAuto = asked == kAutoMinUtilization;
  if (isAuto ? reached >= kPoor || options.texelDensity != kAutoTexelDensity : reached >= asked)
    return {};
  const Occupants occupants = occupantsOf(charts, options.resolution);
  if (isAuto && !occupants.isAnyLong) return {};
  const auto cuts = std::min(static_cast<std::size_t>(atlas.packingCuts), charts.set.size());
  const CutMode mode = cutModeOf(options, charts.flat, cuts);
  return "charts cover " + shareText(reached, asked) + ": " +
         reason(occupants, mode, charts.flat, map, options);
}

}  // namespace abflat
