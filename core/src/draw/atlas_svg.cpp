#include <algorithm>

#include "abflat/draw.h"
#include "base/number_text.h"
#include "draw/atlas_polygons.h"
#include "draw/colours.h"
#include "draw/layout_outline.h"
#include "draw/svg_writer.h"
#include "draw/theme.h"

namespace abflat {
namespace {

/// Units of the drawing along the longer side of a tile: coordinates are whole numbers.
constexpr double kSide = 100000;

using Trails = std::vector<std::vector<std::uint32_t>>;

/// What is drawn of a chart.
struct ChartTrails {
  Trails outline, inner;
};

std::vector<ChartTrails> trailsByChart(const PolygonMesh& mesh, const UnwrapResult& result) {
  std::vector<ChartTrails> out(result.report.charts.size());
  std::vector<std::uint32_t> chartOf(result.uv.size() / 2, 0);
  const AtlasPolygons polygons = atlasPolygons(mesh, result);
  for (std::uint32_t i = 0; i < polygons.count(); ++i)
    for (std::uint32_t c = polygons.offsets[i]; c < polygons.offsets[i + 1]; ++c)
      chartOf[result.cornerUv[polygons.corners[c]]] = result.chartOfFace[polygons.face[i]];
  const AtlasEdges edges = atlasEdges(polygons, result.cornerUv);
  const auto distribute = [&](const std::vector<std::array<std::uint32_t, 2>>& pairs,
                              Trails ChartTrails::*kind) {
    std::vector<std::array<std::uint32_t, 4>> all;
    all.reserve(pairs.size());
    for (const auto& [from, to] : pairs) all.push_back({from, to, 0, 0});
    for (std::vector<std::uint32_t>& trail : trails(all, chartOf.size()))
      (out[chartOf[trail.front()]].*kind).push_back(std::move(trail));
  };
  distribute(edges.outline, &ChartTrails::outline);
  distribute(edges.inner, &ChartTrails::inner);
  return out;
}

/// Units of the drawing along u and v.
struct Tile {
  double width = kSide, height = kSide;
};

Tile tileOf(const AtlasReport& atlas) {
  const double unit = kSide / std::max(atlas.width, atlas.height);
  return {atlas.width * unit, atlas.height * unit};
}

/// `top`: the v of the upper border.
std::string pathOf(const Trails& trails, const std::vector<double>& uv, const Tile& tile, int top) {
  SvgPath path;
  for (const std::vector<std::uint32_t>& trail : trails) {
    const bool isClosed = trail.size() > 2 && trail.front() == trail.back();
    for (std::size_t i = 0; i + (isClosed ? 1 : 0) < trail.size(); ++i) {
      const double* at = &uv[2 * static_cast<std::size_t>(trail[i])];
      path.add(i == 0, at[0] * tile.width, (top - at[1]) * tile.height);
    }
    if (isClosed) path.close();
  }
  return path.data();
}

/// With as many digits as it takes to tell the size from others.
std::string lengthText(double value) {
  std::array<char, kMostDoubleChars> text{};
  return {text.data(), writeDouble(text.data(), value)};
}

struct Size {
  double width = 0, height = 0;  ///< of a tile
  const char* unit = "";         ///< of these
  double thin = 0, thick = 0;    ///< lines, in units of the drawing
};

Size sizeOf(const AtlasReport& atlas, double millimetres) {
  constexpr double kThinPixels = 0.5, kThickPixels = 2, kThinMm = 0.1, kThickMm = 0.4;
  if (!(millimetres > 0 && atlas.texelDensity > 0)) {
    const double unit = kSide / std::max(atlas.width, atlas.height);
    return {static_cast<double>(atlas.width), static_cast<double>(atlas.height), "",
            kThinPixels * unit, kThickPixels * unit};
  }
  const auto length = [&](int texels) { return texels / atlas.texelDensity * millimetres; };
  const double unit = kSide / length(std::max(atlas.width, atlas.height));
  // Lines must not be wider than the charts where those are tiny.
  const double most = kSide / 100;
  return {length(atlas.width), length(atlas.height), "mm", std::min(kThinMm * unit, most / 4),
          std::min(kThickMm * unit, most)};
}

}  // namespace

std::string atlasSvg(const PolygonMesh& mesh, const UnwrapResult& result, double millimetres) {
  const AtlasReport& atlas = result.report.atlas;
  const Size size = sizeOf(atlas, millimetres);
  const Tile tile = tileOf(atlas);
  const std::vector<ChartTrails> charts = trailsByChart(mesh, result);
  SvgWriter out;
  out.raw("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
  out.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"width", lengthText(size.width * tileColumns(atlas)) + size.unit},
                   {"height", lengthText(size.height * tileRows(atlas)) + size.unit},
                   {"viewBox", "0 0 " + svgNumber(tile.width * tileColumns(atlas)) + " " +
                                   svgNumber(tile.height * tileRows(atlas))},
                   {"stroke", kInk},
                   {"stroke-linejoin", "round"},
                   {"stroke-linecap", "round"}});
  for (std::size_t i = 0; i < charts.size(); ++i) {
    if (result.report.charts[i].stackedOn >= 0) continue;
    const std::string outline = pathOf(charts[i].outline, result.uv, tile, tileRows(atlas));
    out.open("g", {{"id", "chart-" + std::to_string(i)}});
    out.add("path", {{"class", "area"},
                     {"d", outline},
                     {"fill", colourText(chartColour(static_cast<std::uint32_t>(i)))},
                     {"stroke", "none"}});
    if (!charts[i].inner.empty())
      out.add("path", {{"class", "edges"},
                       {"d", pathOf(charts[i].inner, result.uv, tile, tileRows(atlas))},
                       {"fill", "none"},
                       {"stroke-width", size.thin}});
    out.add("path",
            {{"class", "outline"}, {"d", outline}, {"fill", "none"}, {"stroke-width", size.thick}});
    out.close("g");
  }
  out.close("svg");
  return out.take();
}

}  // namespace abflat
