#pragma once

#include <string_view>

namespace abflat {

// Colours that people with colour vision deficiencies can tell apart (Okabe and Ito), and that
// differ in lightness on black and white prints.
constexpr std::string_view kFont =
    "system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif";
constexpr std::string_view kPaper = "#ffffff";
constexpr std::string_view kInk = "#1b2430";
constexpr std::string_view kMuted = "#5c6878";
constexpr std::string_view kGrid = "#dde2e9";
constexpr std::string_view kSurface = "#eef3fa";
constexpr std::string_view kEdge = "#7d93b2";
constexpr std::string_view kGood = "#00785a";
constexpr std::string_view kBad = "#c8351f";
constexpr std::string_view kHessian = "#0072b2";
constexpr std::string_view kHighlight = "#e07b00";
constexpr std::string_view kCurveColours[] = {"#1b2430", "#0072b2", "#009e73", "#d55e00",
                                              "#b0569b", "#a8790a", "#56b4e9"};
constexpr std::size_t kCurveColourCount = sizeof(kCurveColours) / sizeof(kCurveColours[0]);

}  // namespace abflat
