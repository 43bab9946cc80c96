#include <algorithm>
#include <cmath>

#include "abflat/draw.h"
#include "base/guarded.h"
#include "draw/kkt_pattern.h"
#include "draw/panel.h"
#include "draw/svg_writer.h"
#include "draw/theme.h"

namespace abflat {
namespace {

/// Dots of the raster along one side, since a large matrix has more rows than a picture has pixels.
constexpr std::size_t kRaster = 420;
constexpr double kLeft = 104, kTop = 76, kSize = 420, kStrip = 40;
constexpr double kStripTop = kTop + kSize + 34;
constexpr double kMinLabelGap = 16;

void addBox(SvgPath& path, double x0, double y0, double x1, double y1) {
  path.moveTo(x0, y0);
  path.lineTo(x1, y0);
  path.lineTo(x1, y1);
  path.lineTo(x0, y1);
  path.close();
}

std::string grouped(std::size_t n) {
  std::string out = std::to_string(n);
  for (std::size_t i = out.size(); i > 3; i -= 3) out.insert(i - 3, ",");
  return out;
}

/// Which dots of the raster have an entry in them, inside or outside the Hessian.
class Raster {
 public:
  Raster(const KktPattern& pattern, bool isHessian)
      : side_(std::min(kRaster, pattern.size)), isSet_(side_ * side_, 0) {
    const auto place = [&](std::uint32_t i) { return i * side_ / pattern.size; };
    const std::size_t angles = pattern.blocks.front().end;
    for (const auto& [row, column] : pattern.entries)
      if ((row < angles && column < angles) == isHessian)
        isSet_[place(row) * side_ + place(column)] = 1;
  }

  /// Runs of dots as rectangles; the whole raster is `size` long.
  SvgPath path(double size) const {
    SvgPath out;
    const auto at = [&](std::size_t i) {
      return size * static_cast<double>(i) / static_cast<double>(side_);
    };
    for (std::size_t y = 0; y < side_; ++y)
      for (std::size_t x = 0; x < side_; ++x) {
        if (!isSet(x, y)) continue;
        const std::size_t start = x;
        while (x < side_ && isSet(x, y)) ++x;
        addBox(out, at(start), at(y), at(x), at(y + 1));
      }
    return out;
  }

 private:
  bool isSet(std::size_t x, std::size_t y) const { return isSet_[y * side_ + x] != 0; }

  std::size_t side_;
  std::vector<std::uint8_t> isSet_;
};

void paintPath(SvgWriter& out, const SvgPath& path, double y, std::string_view colour) {
  if (path.isEmpty()) return;
  const std::string place = "translate(" + svgNumber(kLeft) + " " + svgNumber(y) + ") scale(0.1)";
  out.add("path", {{"d", path.data()}, {"fill", colour}, {"transform", place}});
}

/// The last rows are too few to be seen among thousands, so they are drawn once more, taller.
void paintActiveBounds(SvgWriter& out, const KktPattern& p) {
  const KktBlock& bounds = p.blocks.back();
  const std::size_t count = bounds.end - bounds.begin, angles = p.blocks.front().end;
  out.text(
      kLeft, kStripTop - 9,
      count == 0 ? "no bound is active" : "active bounds (rows) and angles (columns), enlarged",
      {{"font-size", 12}, {"fill", kMuted}});
  if (count == 0) return;
  SvgPath dots;
  for (const auto& [row, column] : p.entries) {
    if (row < bounds.begin || column >= angles) continue;
    const double x = kUnitsPerPixel * kSize * column / static_cast<double>(angles);
    const double step = kUnitsPerPixel * kStrip / static_cast<double>(count);
    const double y = step * static_cast<double>(row - bounds.begin);
    addBox(dots, x - kUnitsPerPixel, y, x + kUnitsPerPixel, y + step);
  }
  out.add("rect", {{"x", kLeft},
                   {"y", kStripTop},
                   {"width", kSize},
                   {"height", kStrip},
                   {"fill", "none"},
                   {"stroke", kMuted}});
  paintPath(out, dots, kStripTop, kInk);
}

void paintBlocks(SvgWriter& out, const KktPattern& pattern) {
  const auto place = [&](std::size_t i) {
    return kSize * static_cast<double>(i) / static_cast<double>(pattern.size);
  };
  double lastY = -kMinLabelGap;
  for (const KktBlock& block : pattern.blocks) {
    if (block.end == block.begin) continue;
    const double from = place(block.begin), to = place(block.end), middle = (from + to) / 2;
    if (block.begin > 0) {
      out.add("line", {{"x1", kLeft},
                       {"x2", kLeft + kSize},
                       {"y1", kTop + from},
                       {"y2", kTop + from},
                       {"stroke", kHighlight},
                       {"stroke-width", 0.7}});
      out.add("line", {{"y1", kTop},
                       {"y2", kTop + kSize},
                       {"x1", kLeft + from},
                       {"x2", kLeft + from},
                       {"stroke", kHighlight},
                       {"stroke-width", 0.7}});
    }
    // Otherwise the names of thin blocks at the end would overlap.
    const double y = std::max(middle, lastY + kMinLabelGap);
    lastY = y;
    out.text(kLeft - 10, kTop + y + 4, block.name, {{"font-size", 12}, {"text-anchor", "end"}});
    out.text(kLeft + kSize + 10, kTop + y + 4, grouped(block.end - block.begin),
             {{"font-size", 12}, {"fill", kMuted}});
  }
}

Result<Drawing> drawKkt(const PolygonMesh& mesh, double t, Formulation formulation) {
  const Result<KktPattern> pattern = kktPattern(mesh, t, formulation);
  if (!pattern.ok()) return pattern.status();
  const KktPattern& p = pattern.value();
  SvgWriter out;
  out.text(kLeft, 18,
           formulation == Formulation::Log ? "logarithmic form, eq. (6): the Hessian is diagonal"
                                           : "product form, eq. (3): full blocks in the Hessian",
           {{"font-size", 15}, {"font-weight", "600"}});
  out.text(
      kLeft, 38,
      grouped(p.size) + " × " + grouped(p.size) + ", " + grouped(p.entries.size()) + " non-zeros",
      {{"font-size", 13}, {"fill", kMuted}});
  out.text(kLeft, 56, grouped(p.hessianEntries) + " of them in the Hessian",
           {{"font-size", 13}, {"fill", kMuted}});
  out.add("rect", {{"x", kLeft},
                   {"y", kTop},
                   {"width", kSize},
                   {"height", kSize},
                   {"fill", "none"},
                   {"stroke", kInk}});
  paintPath(out, Raster(p, false).path(kUnitsPerPixel * kSize), kTop, kInk);
  paintPath(out, Raster(p, true).path(kUnitsPerPixel * kSize), kTop, kHessian);
  paintBlocks(out, p);
  paintActiveBounds(out, p);
  return Drawing{kLeft + kSize + 70, kStripTop + kStrip + 4, out.take()};
}

}  // namespace

Result<Drawing> drawKktMatrix(const PolygonMesh& mesh, double t, Formulation formulation) {
  return guarded([&] { return drawKkt(mesh, t, formulation); });
}

}  // namespace abflat
