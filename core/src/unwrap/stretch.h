#pragma once

#include "unwrap/chart.h"

namespace abflat {

/// The limit for Distortion::sheared. Who allows more stretch allows more of the surface to be
/// sheared.
double mostSheared(const UnwrapOptionValues& options);

/// What has to stay within options.maxStretch: the mean over the chart, or more if too large a
/// share of it is sheared.
double stretchOf(const ChartDistortion& distortion, const UnwrapOptionValues& options);

/// Whether that is above options.maxStretch. What is fixed stays as it is.
bool isStretched(const FlatChart& chart, const UnwrapOptionValues& options);

}  // namespace abflat
