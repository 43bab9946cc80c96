#pragma once

#include "abflat/unwrap.h"
#include "random_source.h"

namespace abflat::fuzz {

/// A value for every option, the default mostly; each value of each choice, and for numbers some
/// within the range and some at its ends.
template <class Options>
void randomValues(Options& options, RandomSource& random) {
  const int count = static_cast<int>(optionInfos(options).count);
  for (int i = 0; i < count; ++i) {
    if (random.below(3) != 1) continue;
    const double value = random.flag()
                             ? random.below(8)
                             : random.pick({0.5, 0.968, 1.001, 1.02, 1.2, 1.5, 1.99, 2.5, 16.0,
                                            64.0, 256.0, 1024.0, 1e-3, 1e-300, 1e6, 1e300,
                                            256 + 64 * kHeightUnit, 100 + 700 * kHeightUnit});
    Options tried = options;
    if (setOption(tried, i, value)) options = tried;
  }
}

template <class Options>
void randomOptions(Options& options, RandomSource& random) {
  randomValues(options, random);
  options.threads = options.threads > 2 ? 2 : options.threads;  // as many as are worth the time
}

}  // namespace abflat::fuzz
