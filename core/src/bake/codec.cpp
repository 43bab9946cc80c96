#include "bake/codec.h"

#include "base/portable_math.h"

namespace abflat {
namespace {

double linearOf(double srgb) {
  if (srgb <= 0.04045) return srgb / 12.92;
  return portable::exp(2.4 * portable::log((srgb + 0.055) / 1.055));
}

/// So many that few numbers share a cell where they are closest, which is where it is dark.
std::uint32_t cellsFor(std::uint32_t most) { return most < 256 ? 1u << 12 : 1u << 17; }

}  // namespace

Codec::Codec(ColourSpace space, int bits) : most_((1u << bits) - 1) {
  const double most = most_;
  for (std::uint32_t code = 0; code <= most_; ++code) {
    const double at = code / most;
    values_.push_back(static_cast<float>(space == ColourSpace::Srgb ? linearOf(at) : at));
  }
  if (space == ColourSpace::Linear) return;
  for (std::uint32_t code = 0; code <= most_; ++code)
    lower_.push_back(code > 0 ? static_cast<float>(linearOf((code - 0.5) / most)) : 0);
  const std::uint32_t cells = cellsFor(most_);
  cells_ = static_cast<float>(cells);
  std::uint32_t code = 0;
  for (std::uint32_t i = 0; i <= cells; ++i) {
    while (code < most_ && static_cast<float>(i) / cells_ >= lower_[code + 1]) ++code;
    firstIn_.push_back(code);
  }
}

}  // namespace abflat
