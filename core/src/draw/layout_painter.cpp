#include "draw/layout_painter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "draw/colours.h"
#include "draw/png_writer.h"
#include "draw/theme.h"

namespace abflat {
namespace {

constexpr double kThin = 1, kThick = 2, kRing = 3;  // pixels
constexpr double kRingRadius = 14;
constexpr int kRingSides = 24;
constexpr int kBandRows = 64;

using Point = PixelPoint;
using Indices = std::vector<std::uint32_t>;

class PngPainter {
 public:
  PngPainter(const PaintedLayout& layout, const PictureFrame& frame)
      : layout_(layout), frame_(frame) {}

  Result<std::string> png(const PaintOptions& options) const {
    const AtlasEdges& edges = layout_.edges;
    const auto areas =
        byBand(layout_.areas.count(), 0, [&](std::uint32_t i) { return pointsOf(i); });
    const auto inner = linesByBand(options.hasInnerEdges, edges.inner);
    const auto outline = linesByBand(true, edges.outline);
    const auto rings = byBand(layout_.marks.size(), kRingRadius + kRing,
                              [&](std::uint32_t i) { return std::array{layout_.marks[i]}; });
    const float thinOpacity = innerOpacity();
    PngWriter out(static_cast<std::uint32_t>(frame_.width),
                  static_cast<std::uint32_t>(frame_.height));
    for (std::size_t b = 0; b < areas.size(); ++b) {
      const int firstRow = static_cast<int>(b) * kBandRows;
      Band band(frame_.width, firstRow, std::min(kBandRows, frame_.height - firstRow));
      for (const std::uint32_t i : areas[b]) band.fill(pointsOf(i), options.colourOf(i));
      for (const std::uint32_t e : inner[b]) draw(band, Band::Line::Thin, edges.inner[e], kThin);
      for (const std::uint32_t e : outline[b])
        draw(band, Band::Line::Thick, edges.outline[e], kThick);
      for (const std::uint32_t i : rings[b]) drawRing(band, layout_.marks[i]);
      out.addRows(band.rgba({parseColour(kInk), thinOpacity, 1, parseColour(kBad)}));
    }
    return out.finish();
  }

 private:
  using Edge = std::array<std::uint32_t, 2>;

  Point at(std::uint32_t texcoord) const {
    return frame_.at(&layout_.uv[2 * static_cast<std::size_t>(texcoord)]);
  }

  std::vector<Point> pointsOf(std::uint32_t area) const {
    const AtlasPolygons& areas = layout_.areas;
    std::vector<Point> out;
    for (std::uint32_t c = areas.offsets[area]; c < areas.offsets[area + 1]; ++c)
      out.push_back(at(layout_.cornerUv[areas.corners[c]]));
    return out;
  }

  /// Indices of the shapes that reach into each band, with a margin in pixels.
  template <class Points>
  std::vector<Indices> byBand(std::size_t count, double margin, const Points& points) const {
    const int bands = (frame_.height + kBandRows - 1) / kBandRows;
    const auto bandOf = [&](double y) {
      return static_cast<std::size_t>(std::clamp(std::floor(y / kBandRows), 0.0, bands - 1.0));
    };
    std::vector<Indices> out(static_cast<std::size_t>(bands));
    for (std::uint32_t i = 0; i < count; ++i) {
      double low = frame_.height, high = 0;
      for (const Point& p : points(i)) {
        low = std::min(low, p.y);
        high = std::max(high, p.y);
      }
      for (std::size_t b = bandOf(low - margin); b <= bandOf(high + margin); ++b)
        out[b].push_back(i);
    }
    return out;
  }

  std::vector<Indices> linesByBand(bool isWanted, const std::vector<Edge>& edges) const {
    return byBand(isWanted ? edges.size() : 0, kThick, [&](std::uint32_t e) {
      return std::array<Point, 2>{at(edges[e][0]), at(edges[e][1])};
    });
  }

  void draw(Band& band, Band::Line kind, const Edge& edge, double width) const {
    band.draw(kind, at(edge[0]), at(edge[1]), width);
  }

  static void drawRing(Band& band, const Point& middle) {
    constexpr double kTurn = 6.283185307179586;
    const auto corner = [&](int k) {
      const double angle = kTurn * k / kRingSides;
      return Point{middle.x + kRingRadius * std::cos(angle),
                   middle.y + kRingRadius * std::sin(angle)};
    };
    for (int k = 0; k < kRingSides; ++k)
      band.draw(Band::Line::Mark, corner(k), corner(k + 1), kRing);
  }

  /// Edges as dense as pixels would hide the colours.
  float innerOpacity() const {
    constexpr double kSparse = 12, kMost = 0.45, kLeast = 0.08;
    double sum = 0;
    const std::vector<Edge>& edges = layout_.edges.inner;
    for (const Edge& e : edges) {
      const Point a = at(e[0]), b = at(e[1]);
      sum += std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
    }
    const double mean = edges.empty() ? 0 : sum / static_cast<double>(edges.size());
    return static_cast<float>(std::max(kLeast, kMost * std::min(1.0, mean / kSparse)));
  }

  const PaintedLayout& layout_;
  const PictureFrame& frame_;
};

}  // namespace

Result<std::string> paintLayout(const PaintedLayout& layout, const PictureFrame& frame,
                                const PaintOptions& options) {
  return PngPainter(layout, frame).png(options);
}

}  // namespace abflat
