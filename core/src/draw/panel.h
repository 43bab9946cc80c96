#pragma once

#include <string_view>

#include "draw/svg_writer.h"
#include "draw/theme.h"

namespace abflat {

// A title, a square picture, and lines of text below it.
constexpr double kTitleHeight = 26, kPadding = 10;
constexpr double kUnitsPerPixel = 10;  // of path data

inline void paintTitle(SvgWriter& out, std::string_view title) {
  out.text(kPadding, 16, title, {{"font-size", 15}, {"font-weight", "600"}});
}

/// Opens the group of the square, in path units.
inline void openSquare(SvgWriter& out) {
  out.open("g", {{"transform", "translate(0 " + svgNumber(kTitleHeight) + ") scale(0.1)"},
                 {"stroke-linejoin", "round"},
                 {"stroke-linecap", "round"},
                 {"fill", "none"}});
}

}  // namespace abflat
