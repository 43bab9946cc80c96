#pragma once

#include <functional>
#include <vector>

#include "abflat/generated/unwrap_options.h"
#include "boundary/chart_flattener.h"
#include "flatten_chart.h"

namespace abflat {

/// A chart that has been laid out.
struct FlatChart {
  std::vector<double> unpacked;  ///< of the chart's 3D area, in the mesh's unit
  std::vector<double> fixed;     ///< places in the atlas where it stays; empty: packing decides
  std::vector<double> uv;        ///< in the atlas
  Attempt attempt;               ///< its own uv is gone
  std::string problem;           ///< why it is not valid, one sentence; empty when it is

  bool isFixed() const { return !fixed.empty(); }
};

/// `pins` are places in the atlas. `goesOn` is asked often, from the thread that calls; when it
/// returns false the layout is empty.
FlatChart flattenOne(const DiskChart& chart, const UnwrapOptionValues& options,
                     const std::vector<ChartPin>& pins, ThreadPool& pool,
                     const std::function<bool()>& goesOn);

/// Decides anew whether the layout is valid, from the coordinates in the atlas.
void checkInPlace(const DiskChart& chart, FlatChart& flat);

}  // namespace abflat
