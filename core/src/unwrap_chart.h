#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "abflat/generated/unwrap_options.h"
#include "boundary/chart_flattener.h"
#include "flatten_chart.h"

namespace abflat {

/// A chart that has been laid out.
struct FlatChart {
  std::vector<double> unpacked;  ///< of the chart's 3D area, in the mesh's unit
  std::vector<double> uv;        ///< in the atlas
  std::string solver;            ///< as in Attempt
  int iterations = 0;            ///< of the solver
  Distortion distortion;         ///< before rounding
  std::vector<std::string> fallbacks;
  std::optional<PinReport> pins;
  std::optional<StraightReport> straight;
  StraightPlaces straightPlaces;
  std::string problem;  ///< why it is not valid, one sentence; empty when it is
  double enlarged = 1;  ///< beside the others, so that numbers can tell its triangles apart
  std::size_t movedVertices = 0;  ///< for the same reason
  double movedBy = 0;             ///< the farthest of these, along an axis
  bool isFixed = false;           ///< uv are those in the atlas from the start: packing leaves them
  bool isGiven = false;           ///< those of the input, which have been checked
  bool isCutEnough = false;       ///< no seam was found that would stretch it less
  bool isTangled = false;         ///< its boundary crosses itself; a seam may be the better remedy
};

/// What one chart is asked for beyond the options.
struct ChartWishes {
  std::vector<ChartPin> pins;  ///< places in the atlas
  StraightPlaces straight;
  std::size_t released = 0;  ///< places that would be straight as well, but are not
};

/// How much is tried to lay out a chart whose boundary crosses itself.
enum class Patience {
  Little,  ///< some steps for each that the layout took; none where it is to be cut anyway
  All
};

/// `goesOn` is asked often, from the thread that calls; when it
/// returns false the layout is empty.
FlatChart flattenOne(const DiskChart& chart, const UnwrapOptionValues& options,
                     const ChartWishes& wishes, Patience patience, ThreadPool& pool,
                     const std::function<bool()>& goesOn);

/// Decides anew whether the layout is valid, from the coordinates in the atlas.
void checkInPlace(const DiskChart& chart, FlatChart& flat);

}  // namespace abflat
