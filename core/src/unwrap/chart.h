#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "abflat/generated/unwrap_options.h"
#include "base/listener.h"
#include "boundary/chart_flattener.h"
#include "chart/ids.h"
#include "flatten/flatten_chart.h"

namespace abflat {

/// The part of Distortion that reports need.
struct ChartDistortion {
  double angular = 0, quasiConformalMean = 1, quasiConformalMax = 1, sheared = 0,
         symmetricDirichlet = 1;

  ChartDistortion() = default;
  explicit ChartDistortion(const Distortion& d)
      : angular(d.angular),
        quasiConformalMean(d.quasiConformalMean),
        quasiConformalMax(d.quasiConformalMax),
        sheared(d.sheared),
        symmetricDirichlet(d.symmetricDirichlet) {}
};

/// What only some charts have.
struct UncommonParts {
  std::vector<std::string> fallbacks;
  std::optional<RefineReport> refined;
  std::optional<PinReport> pins;
  std::optional<StraightReport> straight;
  StraightPlaces straightPlaces;
};

/// How much effort goes into a chart that has no valid layout at once.
enum class Patience : std::uint8_t {
  Little,  ///< a few steps to untangle it; none if it is to be cut anyway
  Much,    ///< all ways to untangle it
  All      ///< and bounds or Tutte's embedding, which distort
};

/// A chart that has been laid out. There may be as many of these as triangles, so each byte counts.
struct FlatChart {
  std::vector<double> unpacked;  ///< at the chart's 3D area, in the mesh's unit
  std::vector<double> uv;        ///< in the atlas
  double area = 0;               ///< of the chart's surface, in the mesh's unit
  ChartDistortion distortion;    ///< before rounding
  std::unique_ptr<UncommonParts> uncommon;
  std::string problem;              ///< why it is not valid, one sentence; empty if it is valid
  double enlarged = 1;              ///< relative to other charts, to keep its triangles apart
  double movedBy = 0;               ///< largest move of a vertex, along one axis
  std::uint32_t movedVertices = 0;  ///< vertices moved to keep triangles apart after rounding
  int iterations = 0;               ///< of the solver
  Solver solver = Solver::ActiveSet;
  ChartShape shape = ChartShape::Other;
  bool isFixed = false;      ///< uv is its place in the atlas from the start; packing leaves it
  bool isGiven = false;      ///< uv is that of the input or an earlier run, which has been checked
  bool isStacked = false;    ///< it stays on another chart that stays
  bool isCutEnough = false;  ///< no seam was found that would reduce its stretch
  bool isWhole = false;      ///< it cannot be split in two either
  bool isDrawnOut = false;   ///< its outline is many times as long as on the surface
  Patience patience = Patience::All;

  /// A seam, or more patience, may be the better remedy.
  bool isGivenUp() const { return !problem.empty() && patience != Patience::All; }
};

using FlatCharts = IdVector<ChartId, FlatChart>;

/// What is asked of one chart beyond the options.
struct ChartConstraints {
  std::vector<ChartPin> pins;  ///< positions in the atlas
  StraightPlaces straight;
  std::size_t released = 0;  ///< places that should be straight as well, but are not
};

/// Coordinates in the mesh's unit as the chart's own, exactly.
std::vector<double> inChartUnit(const DiskChart& chart, std::vector<double> uv);

/// Area of the surface, in the mesh's unit.
double areaOf(const DiskChart& chart);

/// Scales coordinates in the mesh's unit so that the layout has the area of the surface. False if
/// it has none.
bool scaleToSurface(const DiskChart& chart, std::vector<double>& uv);

/// Once `listener` has stopped, the layout is empty.
FlatChart flattenOne(const DiskChart& chart, const UnwrapOptionValues& options,
                     const ChartConstraints& constraints, Patience patience, ThreadPool& pool,
                     const Listener& listener);

/// Decides again whether the layout is valid, from its coordinates in the atlas.
void checkInPlace(const DiskChart& chart, FlatChart& flat);

}  // namespace abflat
