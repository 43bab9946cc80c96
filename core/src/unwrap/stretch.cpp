#include "unwrap/stretch.h"

#include <algorithm>

namespace abflat {

double mostSheared(const UnwrapOptionValues& options) {
  constexpr double kLeast = 0.1, kPerStretch = 5;
  return options.maxSheared == kAutoMaxSheared
             ? std::max(kLeast, kPerStretch * (options.maxStretch - 1))
             : options.maxSheared;
}

double stretchOf(const ChartDistortion& distortion, double leeway,
                 const UnwrapOptionValues& options) {
  const double ofShear = 1 + (options.maxStretch - 1) * distortion.sheared / mostSheared(options);
  return 1 + (std::max(distortion.symmetricDirichlet, ofShear) - 1) / leeway;
}

bool isStretched(const FlatChart& chart, double leeway, const UnwrapOptionValues& options) {
  return !chart.isFixed && stretchOf(chart.distortion, leeway, options) > options.maxStretch;
}

}  // namespace abflat
