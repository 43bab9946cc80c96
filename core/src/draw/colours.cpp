#include "draw/colours.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"

namespace abflat {
namespace {

Rgb mixed(const Rgb& a, const Rgb& b, double share) {
  Rgb out{};
  const auto t = static_cast<float>(share);
  for (std::size_t d = 0; d < 3; ++d) out[d] = a[d] * (1 - t) + b[d] * t;
  return out;
}

float channel(double hue, double offset, double lightness, double chroma) {
  const double turn = hue + offset - std::floor(hue + offset);
  const double wave = std::clamp(std::abs(turn * 6 - 3) - 1, 0.0, 1.0);
  return static_cast<float>(lightness + chroma * (wave - 0.5));
}

int digit(char c) { return c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10; }

}  // namespace

Rgb parseColour(std::string_view hex) {
  Rgb out{};
  for (std::size_t d = 0; d < 3; ++d)
    out[d] = static_cast<float>(16 * digit(hex[1 + 2 * d]) + digit(hex[2 + 2 * d])) / 255;
  return out;
}

std::string colourText(const Rgb& colour) {
  std::string out = "#";
  for (const float value : colour) {
    const long byte = std::lround(std::clamp(value, 0.0f, 1.0f) * 255);
    for (const long d : {byte / 16, byte % 16}) out += "0123456789abcdef"[d];
  }
  return out;
}

Rgb chartColour(std::uint32_t chart) {
  constexpr double kGoldenRatio = 0.6180339887498949;
  constexpr double kLightness[] = {0.81, 0.88, 0.76}, kChroma[] = {0.30, 0.20, 0.32};
  const double hue = 0.57 + kGoldenRatio * chart;
  const double lightness = kLightness[chart % 3], chroma = kChroma[chart % 3];
  return {channel(hue, 0, lightness, chroma), channel(hue, 2.0 / 3, lightness, chroma),
          channel(hue, 1.0 / 3, lightness, chroma)};
}

Rgb ratioColour(double ratio) {
  const Rgb middle = parseColour("#f7f7f7");
  const double octaves = std::clamp(portable::log(ratio) / portable::log(2), -1.0, 1.0);
  return octaves < 0 ? mixed(middle, parseColour("#2166ac"), -octaves)
                     : mixed(middle, parseColour("#b2182b"), octaves);
}

}  // namespace abflat
