#pragma once

#include "unwrap/chart.h"

namespace abflat {

/// The limit for Distortion::sheared. Who allows more stretch allows more of the surface to be
/// sheared.
double mostSheared(const UnwrapOptionValues& options);

/// What has to stay within options.maxStretch: the mean over the chart, or more if too large a
/// share of it is sheared. What exceeds 1 counts `leeway` times less; see ChartSet.
double stretchOf(const ChartDistortion& distortion, double leeway,
                 const UnwrapOptionValues& options);

/// Whether that is above options.maxStretch. What is fixed stays as it is.
bool isStretched(const FlatChart& chart, double leeway, const UnwrapOptionValues& options);

}  // namespace abflat
