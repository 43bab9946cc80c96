#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "abflat/draw.h"
#include "base/counted.h"
#include "base/point2.h"
#include "check/crossings.h"
#include "draw/layout_outline.h"
#include "draw/panel.h"
#include "exact/in_circle.h"
#include "exact/orientation.h"

namespace abflat {
namespace {

constexpr double kCaptionHeight = 62;
constexpr std::size_t kMaxMarks = 400;

/// uv to path units; the v axis of pictures points down.
class Fit {
 public:
  Fit(const std::vector<double>& uv, double size) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Point2 low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};
    for (std::size_t i = 0; i < uv.size(); ++i) {
      if (!std::isfinite(uv[i])) continue;
      low[i % 2] = std::min(low[i % 2], uv[i]);
      high[i % 2] = std::max(high[i % 2], uv[i]);
    }
    const double extent = std::max(high[0] - low[0], high[1] - low[1]);
    scale_ = extent > 0 ? (size - 2 * kPadding) * kUnitsPerPixel / extent : 0;
    for (std::size_t d = 0; d < 2; ++d) middle_[d] = (low[d] + high[d]) / 2;
    center_ = size * kUnitsPerPixel / 2;
  }

  Point2 operator()(const double* uv) const {
    const auto at = [&](std::size_t d) {
      return std::isfinite(uv[d]) ? scale_ * (uv[d] - middle_[d]) : 0;
    };
    return {center_ + at(0), center_ - at(1)};
  }

 private:
  double scale_ = 0, center_ = 0;
  Point2 middle_{};
};

/// Where two segments meet; their middle when they are parallel.
Point2 meeting(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Point2 r{b[0] - a[0], b[1] - a[1]}, s{d[0] - c[0], d[1] - c[1]};
  const double cross = r[0] * s[1] - r[1] * s[0];
  const double along = (c[0] - a[0]) * s[1] - (c[1] - a[1]) * s[0];
  const double t = cross == 0 ? 0.5 : std::clamp(along / cross, 0.0, 1.0);
  return {a[0] + t * r[0], a[1] + t * r[1]};
}

class LayoutPainter {
 public:
  LayoutPainter(const FlattenResult& flat, const LayoutDrawingOptions& options)
      : flat_(flat), options_(options), outline_(outlineOf(flat)), fit_(flat.uv, options.size) {}

  /// How many edges were marked as not Delaunay.
  std::size_t paint(SvgWriter& out) {
    openSquare(out);
    paintSurface(out);
    const std::size_t marked = options_.marksNonDelaunay ? paintNonDelaunay(out) : 0;
    const SvgPath boundary = loop();
    out.add("path", {{"d", boundary.data()}, {"stroke", kInk}, {"stroke-width", 16}});
    paintCrossings(out);
    out.close("g");
    return marked;
  }

 private:
  const double* uv(std::uint32_t v) const { return &flat_.uv[2 * std::size_t{v}]; }
  Point2 at(std::uint32_t v) const { return fit_(uv(v)); }

  SvgPath loop() const {
    SvgPath path;
    for (std::size_t i = 0; i < outline_.boundary.size(); ++i) {
      const Point2 p = at(outline_.boundary[i]);
      path.add(i == 0, p[0], p[1]);
    }
    if (!path.isEmpty()) path.close();
    return path;
  }

  SvgPath flippedTriangles() const {
    SvgPath path;
    for (std::size_t f = 0; f < flat_.triangles.size(); f += 3) {
      const std::uint32_t* v = &flat_.triangles[f];
      if (orientation(uv(v[0]), uv(v[1]), uv(v[2])) > 0) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point2 p = at(v[k]);
        path.add(k == 0, p[0], p[1]);
      }
      path.close();
    }
    return path;
  }

  /// Edges get thinner as they get denser, so that large meshes do not become black.
  double edgeWidth() const {
    const double spacing =
        options_.size / std::sqrt(static_cast<double>(outline_.inner.size()) + 1);
    return std::clamp(0.9 * spacing, 1.2, 6.0);
  }

  void paintSurface(SvgWriter& out) const {
    out.add("path", {{"d", loop().data()}, {"fill", kSurface}, {"fill-rule", "nonzero"}});
    SvgPath edges;
    for (const std::vector<std::uint32_t>& trail : trails(outline_.inner, flat_.uv.size() / 2)) {
      for (std::size_t i = 0; i < trail.size(); ++i) {
        const Point2 p = at(trail[i]);
        edges.add(i == 0, p[0], p[1]);
      }
    }
    if (!edges.isEmpty())
      out.add("path", {{"d", edges.data()}, {"stroke", kEdge}, {"stroke-width", edgeWidth()}});
    const SvgPath flipped = flippedTriangles();
    if (!flipped.isEmpty())
      out.add("path",
              {{"d", flipped.data()}, {"fill", kBad}, {"stroke", kBad}, {"stroke-width", 8}});
  }

  /// Whether both triangles at the edge are upright and neither's circumcircle contains the other's
  /// apex.
  bool isDelaunay(const std::array<std::uint32_t, 4>& edge) const {
    const auto [from, to, left, right] = edge;
    return orientation(uv(from), uv(to), uv(left)) > 0 &&
           orientation(uv(to), uv(from), uv(right)) > 0 &&
           inCircle(uv(from), uv(to), uv(left), uv(right)) <= 0;
  }

  std::size_t paintNonDelaunay(SvgWriter& out) const {
    SvgPath quads, edges;
    std::size_t count = 0;
    for (const auto& edge : outline_.inner) {
      if (isDelaunay(edge)) continue;
      const auto [from, to, left, right] = edge;
      ++count;
      const Point2 a = at(from), b = at(to), c = at(left), d = at(right);
      quads.moveTo(a[0], a[1]);
      for (const Point2& p : {d, b, c}) quads.lineTo(p[0], p[1]);
      quads.close();
      edges.moveTo(a[0], a[1]);
      edges.lineTo(b[0], b[1]);
    }
    if (count == 0) return 0;
    out.add("path", {{"d", quads.data()}, {"fill", kHighlight}, {"fill-opacity", "0.3"}});
    out.add("path", {{"d", edges.data()}, {"stroke", kHighlight}, {"stroke-width", 14}});
    return count;
  }

  void paintCrossings(SvgWriter& out) const {
    std::vector<double> points;
    for (const std::uint32_t v : outline_.boundary) points.insert(points.end(), uv(v), uv(v) + 2);
    const std::size_t n = outline_.boundary.size();
    for (const auto& [i, j] : findCrossings(points, kMaxMarks).first) {
      const auto corner = [&](std::size_t k) { return at(outline_.boundary[k % n]); };
      const Point2 p = meeting(corner(i), corner(i + 1), corner(j), corner(j + 1));
      out.add("circle", {{"cx", p[0]},
                         {"cy", p[1]},
                         {"r", 55},
                         {"stroke", kBad},
                         {"stroke-width", 22},
                         {"fill", kBad},
                         {"fill-opacity", "0.25"}});
    }
  }

  const FlattenResult& flat_;
  const LayoutDrawingOptions& options_;
  const LayoutOutline outline_;
  const Fit fit_;
};

std::string verdict(const ChartReport& c) {
  if (c.valid) return "valid";
  std::string out;
  if (c.boundaryCrossings > 0) out += counted(c.boundaryCrossings, "crossing", "crossings");
  if (c.flippedTriangles > 0)
    out += (out.empty() ? "" : ", ") +
           counted(c.flippedTriangles, "flipped triangle", "flipped triangles");
  if (out.empty() && !c.converged) out = "not converged";
  return "not valid" + (out.empty() ? "" : ": " + out);
}

std::string distortions(const ChartReport& c) {
  std::ostringstream out;
  out.precision(3);
  out << "distortion: angles " << c.angularDistortion << ", lengths " << c.lengthDistortion;
  return out.str();
}

}  // namespace

Drawing drawLayout(const FlattenResult& flat, const LayoutDrawingOptions& options) {
  const ChartReport& chart = flat.report.charts.front();
  SvgWriter out;
  paintTitle(out, options.title);
  const std::size_t marked = LayoutPainter(flat, options).paint(out);
  const double y = kTitleHeight + options.size + 16;
  out.text(kPadding, y, distortions(chart), {{"font-size", 13}, {"fill", kMuted}});
  const std::string_view colour = chart.valid ? kGood : kBad;
  out.text(kPadding, y + 18, verdict(chart),
           {{"font-size", 13}, {"font-weight", "600"}, {"fill", colour}});
  if (options.marksNonDelaunay)
    out.text(kPadding, y + 36,
             marked == 0 ? "every edge is Delaunay"
                         : counted(marked, "edge is not Delaunay", "edges are not Delaunay"),
             {{"font-size", 13}, {"fill", marked == 0 ? kGood : kHighlight}});
  return {options.size, kTitleHeight + options.size + kCaptionHeight, out.take()};
}

Drawing drawReason(const std::string& reason, const LayoutDrawingOptions& options) {
  constexpr double kLineHeight = 19, kCharacter = 7.2;
  SvgWriter out;
  paintTitle(out, options.title);
  const double side = options.size - 2 * kPadding;
  out.add("rect", {{"x", kPadding},
                   {"y", kTitleHeight + kPadding},
                   {"width", side},
                   {"height", side},
                   {"rx", 6},
                   {"fill", "none"},
                   {"stroke", kGrid},
                   {"stroke-dasharray", "6 5"}});
  const auto width = static_cast<std::size_t>((side - 30) / kCharacter);
  std::istringstream words(reason);
  std::vector<std::string> lines(1);
  for (std::string word; words >> word;) {
    if (!lines.back().empty() && lines.back().size() + word.size() >= width) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  double y =
      kTitleHeight + options.size / 2 - kLineHeight * (static_cast<double>(lines.size()) - 1) / 2;
  for (const std::string& line : lines) {
    out.text(options.size / 2, y, line,
             {{"font-size", 13}, {"fill", kMuted}, {"text-anchor", "middle"}});
    y += kLineHeight;
  }
  return {options.size, kTitleHeight + options.size + kCaptionHeight, out.take()};
}

}  // namespace abflat
