#pragma once

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// How flattening distorted a chart.
struct Stretched {
  double stretch = 0;      ///< above the limit, or of an invalid chart; 0: the chart stays as it is
  bool isInvalid = false;  ///< and has not been refined
};

/// What cutting further has done.
enum class Further : std::uint8_t {
  Nothing,  ///< none of the charts can be cut so that less stretch is expected
  Cut,
  Replaced  ///< the seams are others; charts that stay as they are have not been tried yet
};

/// Cuts charts further that are invalid or stretched by more than `options.maxStretch`. New seams
/// start from those found before, with a prediction corrected by the actual stretch.
Further cutStretched(const ChartSet& set, const IdVector<ChartId, Stretched>& charts,
                     const UnwrapOptions& options, ThreadPool& pool, const Listener& listener,
                     OpenSurface& open);

}  // namespace abflat
