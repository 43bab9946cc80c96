#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "abflat/draw.h"
#include "draw/panel.h"
#include "draw/svg_writer.h"
#include "draw/theme.h"

namespace abflat {
namespace {

constexpr double kLeftMargin = 52, kRightMargin = 14, kTopMargin = 30, kBottomMargin = 44;
constexpr double kLowest = 1e-18;  // nothing below rounding is worth an axis
constexpr int kMaxTicks = 8;

std::string_view curveColour(std::size_t i) { return kCurveColours[i % kCurveColourCount]; }

/// Later curves are thinner, so that curves on top of each other can all be seen.
double widthOf(std::size_t i) { return std::max(1.4, 6.5 - 1.3 * static_cast<double>(i)); }
double dotOf(std::size_t i) { return 0.8 + widthOf(i) / 2; }

/// A whole number, 1, 2 or 5 times a power of ten, that divides `range` into at most `most` pieces.
int niceStep(int range, int most) {
  for (int base = 1;; base *= 10)
    for (const int factor : {1, 2, 5})
      if (range <= factor * base * most) return factor * base;
}

/// mantissa times ten to the exponent; written plainly if that is shorter.
std::string powerText(int mantissa, int exponent) {
  static constexpr std::string_view kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (exponent >= 0 && exponent <= 4)
    return std::to_string(mantissa) + std::string(static_cast<std::size_t>(exponent), '0');
  std::string out = mantissa == 1 ? "10" : std::to_string(mantissa) + "·10";
  if (exponent < 0) out += "⁻";
  for (const char c : std::to_string(std::abs(exponent))) out += kDigits[c - '0'];
  return out;
}

class Axes {
 public:
  Axes(const std::vector<Curve>& curves, const PlotOptions& options) : options_(options) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Curve& curve : curves) {
      last_ = std::max(last_, static_cast<int>(curve.y.size()));
      for (const double y : curve.y) {
        if (!(y > 0) || !std::isfinite(y)) continue;
        low = std::min(low, std::max(y, kLowest));
        high = std::max(high, y);
      }
    }
    if (low > high) low = high = 1;
    lowest_ = static_cast<int>(std::floor(std::log10(low)));
    highest_ = std::max(lowest_ + 1, static_cast<int>(std::ceil(std::log10(high))));
  }

  double px(std::size_t index) const {
    return kLeftMargin +
           (options_.width - kLeftMargin - kRightMargin) * static_cast<double>(index) / (last_ - 1);
  }
  double py(double y) const {
    const double log = y > 0 ? std::log10(y) : lowest_;
    const double share =
        std::clamp((log - lowest_) / static_cast<double>(highest_ - lowest_), 0.0, 1.0);
    return options_.height - kBottomMargin - share * (options_.height - kTopMargin - kBottomMargin);
  }

  void paint(SvgWriter& out) const {
    const int decades = highest_ - lowest_;
    for (int e = lowest_; e <= highest_; e += niceStep(decades, kMaxTicks)) {
      paintLevel(out, 1, e);
      // With so few decades, lines between the powers are needed.
      if (decades <= 2 && e < highest_)
        for (const int mantissa : {2, 5}) paintLevel(out, mantissa, e);
    }
    for (int i = 1; i <= last_; i += niceStep(last_, 2 * kMaxTicks)) {
      const double x = px(static_cast<std::size_t>(i - 1));
      out.add("line", {{"x1", x},
                       {"x2", x},
                       {"y1", kTopMargin},
                       {"y2", options_.height - kBottomMargin},
                       {"stroke", kGrid}});
      out.text(x, options_.height - kBottomMargin + 17, std::to_string(i),
               {{"font-size", 12}, {"fill", kMuted}, {"text-anchor", "middle"}});
    }
    out.text((kLeftMargin + options_.width - kRightMargin) / 2, options_.height - 6,
             options_.xLabel, {{"font-size", 12}, {"fill", kMuted}, {"text-anchor", "middle"}});
    out.text(kLeftMargin, 16, options_.title, {{"font-size", 14}, {"font-weight", "600"}});
  }

 private:
  void paintLevel(SvgWriter& out, int mantissa, int exponent) const {
    const double y = py(mantissa * std::pow(10, exponent));
    out.add("line", {{"x1", kLeftMargin},
                     {"x2", options_.width - kRightMargin},
                     {"y1", y},
                     {"y2", y},
                     {"stroke", kGrid}});
    out.text(kLeftMargin - 8, y + 4, powerText(mantissa, exponent),
             {{"font-size", 12}, {"fill", kMuted}, {"text-anchor", "end"}});
  }

  const PlotOptions& options_;
  int last_ = 2;
  int lowest_ = 0, highest_ = 1;  ///< powers of ten
};

}  // namespace

Drawing drawLogPlot(const std::vector<Curve>& curves, const PlotOptions& options) {
  SvgWriter out;
  const Axes axes(curves, options);
  axes.paint(out);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    SvgPath path;
    for (std::size_t i = 0; i < curves[c].y.size(); ++i) {
      const double x = axes.px(i), y = axes.py(curves[c].y[i]);
      path.add(i == 0, kUnitsPerPixel * x, kUnitsPerPixel * y);
      out.add("circle", {{"cx", x}, {"cy", y}, {"r", dotOf(c)}, {"fill", curveColour(c)}});
    }
    if (path.isEmpty()) continue;
    out.add("path", {{"d", path.data()},
                     {"transform", "scale(0.1)"},
                     {"fill", "none"},
                     {"stroke", curveColour(c)},
                     {"stroke-width", kUnitsPerPixel * widthOf(c)},
                     {"stroke-linejoin", "round"}});
  }
  return {options.width, options.height, out.take()};
}

Drawing drawLegend(const std::vector<std::string>& names, double width) {
  constexpr double kLine = 22, kSample = 34;
  SvgWriter out;
  double y = 12;
  for (std::size_t i = 0; i < names.size(); ++i) {
    out.add("line", {{"x1", 0.0},
                     {"x2", kSample},
                     {"y1", y},
                     {"y2", y},
                     {"stroke", curveColour(i)},
                     {"stroke-width", widthOf(i)}});
    out.add("circle", {{"cx", kSample / 2}, {"cy", y}, {"r", dotOf(i)}, {"fill", curveColour(i)}});
    out.text(kSample + 10, y + 4, names[i], {{"font-size", 13}});
    y += kLine;
  }
  return {width, y, out.take()};
}

}  // namespace abflat
