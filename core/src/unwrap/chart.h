#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "abflat/generated/unwrap_options.h"
#include "boundary/chart_flattener.h"
#include "chart/ids.h"
#include "flatten/flatten_chart.h"

namespace abflat {

/// What reports have of Distortion.
struct ChartDistortion {
  double angular = 0, quasiConformalMean = 1, quasiConformalMax = 1, symmetricDirichlet = 1;

  ChartDistortion() = default;
  explicit ChartDistortion(const Distortion& d)
      : angular(d.angular),
        quasiConformalMean(d.quasiConformalMean),
        quasiConformalMax(d.quasiConformalMax),
        symmetricDirichlet(d.symmetricDirichlet) {}
};

/// What is known of some charts only.
struct UncommonParts {
  std::vector<std::string> fallbacks;
  std::optional<RefineReport> refined;
  std::optional<PinReport> pins;
  std::optional<StraightReport> straight;
  StraightPlaces straightPlaces;
};

/// A chart that has been laid out. There may be as many as triangles: each byte counts.
struct FlatChart {
  std::vector<double> unpacked;  ///< of the chart's 3D area, in the mesh's unit
  std::vector<double> uv;        ///< in the atlas
  double area = 0;               ///< of the surface, in the mesh's unit
  ChartDistortion distortion;    ///< before rounding
  std::unique_ptr<UncommonParts> uncommon;
  std::string problem;  ///< why it is not valid, one sentence; empty when it is
  double enlarged = 1;  ///< beside the others, so that numbers can tell its triangles apart
  double movedBy = 0;   ///< the farthest of the moved vertices, along an axis
  std::uint32_t movedVertices = 0;  ///< for the same reason as it is enlarged
  int iterations = 0;               ///< of the solver
  Solver solver = Solver::ActiveSet;
  bool isFixed = false;      ///< uv are those in the atlas from the start: packing leaves them
  bool isGiven = false;      ///< those of the input, which have been checked
  bool isCutEnough = false;  ///< no seam was found that would stretch it less
  bool isTangled = false;    ///< its boundary crosses itself; a seam may be the better remedy
};

using FlatCharts = IdVector<ChartId, FlatChart>;

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

/// Area of the surface, in the mesh's unit.
double areaOf(const DiskChart& chart);

/// `goesOn` is asked often, from the thread that calls; when it
/// returns false the layout is empty.
FlatChart flattenOne(const DiskChart& chart, const UnwrapOptionValues& options,
                     const ChartWishes& wishes, Patience patience, ThreadPool& pool,
                     const std::function<bool()>& goesOn);

/// Decides anew whether the layout is valid, from the coordinates in the atlas.
void checkInPlace(const DiskChart& chart, FlatChart& flat);

}  // namespace abflat
