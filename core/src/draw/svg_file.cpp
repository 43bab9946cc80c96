#include <algorithm>

#include "abflat/draw.h"
#include "draw/svg_writer.h"
#include "draw/theme.h"

namespace abflat {
namespace {

constexpr double kMargin = 24, kGap = 20, kHeading = 36;

struct Place {
  double x, y;
};

/// Row by row; each row is as high as its highest drawing.
std::vector<Place> arranged(const std::vector<Drawing>& drawings, std::size_t columns,
                            double& width, double& height) {
  std::vector<Place> out;
  double x = kMargin, y = kMargin + kHeading, rowHeight = 0;
  width = 0;
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    if (i > 0 && i % columns == 0) {
      x = kMargin;
      y += rowHeight + kGap;
      rowHeight = 0;
    }
    out.push_back({x, y});
    x += drawings[i].width + kGap;
    rowHeight = std::max(rowHeight, drawings[i].height);
    width = std::max(width, x - kGap + kMargin);
  }
  height = y + rowHeight + kMargin;
  return out;
}

}  // namespace

std::string svgFile(const std::string& heading, const std::vector<Drawing>& drawings,
                    std::size_t columns) {
  double width = 0, height = 0;
  const std::vector<Place> places =
      arranged(drawings, std::max<std::size_t>(columns, 1), width, height);
  SvgWriter out;
  out.raw("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
  out.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"width", width},
                   {"height", height},
                   {"viewBox", "0 0 " + svgNumber(width) + " " + svgNumber(height)},
                   {"font-family", kFont},
                   {"fill", kInk}});
  out.raw("<title>" + xmlText(heading) + "</title>\n");
  out.add("rect", {{"width", width}, {"height", height}, {"fill", kPaper}});
  out.text(kMargin, kMargin + 14, heading, {{"font-size", 18}, {"font-weight", "600"}});
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    out.open("g", {{"transform",
                    "translate(" + svgNumber(places[i].x) + " " + svgNumber(places[i].y) + ")"}});
    out.raw(drawings[i].body);
    out.close("g");
  }
  out.close("svg");
  return out.take();
}

}  // namespace abflat
