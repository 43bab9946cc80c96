#pragma once

#include <algorithm>

namespace abflat {

/// From 0 to 1 where x goes from `low` to `high`, without a kink.
inline double smoothStep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace abflat
