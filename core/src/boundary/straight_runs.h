#pragma once

#include <cstdint>
#include <vector>

#include "abflat/chart_report.h"
#include "abflat/status.h"
#include "chart/disk_chart.h"

namespace abflat {

/// The vertices strictly inside runs of the boundary. Errors: InvalidOption for a run that does not
/// begin and end at different vertices of the boundary; InfeasibleBound if no layout can make them
/// all straight.
Result<StraightPlaces> straightPlaces(const DiskChart& chart, const std::vector<StraightRun>& runs);

/// An inner edge between two boundary places with only straight places between them: the triangles
/// in between would have no area.
struct FlatChord {
  BoundaryIndex from, to;  ///< the straight places follow `from` and end before `to`
};
std::vector<FlatChord> flatChords(const DiskChart& chart, const StraightPlaces& straight);

/// Whether fewer than three places may turn, although all turns have to sum to 2 pi.
bool isTooStraight(const StraightPlaces& straight);

/// Boundary places that are not straight.
std::size_t placesThatTurn(const DiskChart& chart, const StraightPlaces& straight);

/// Vertices of the chart at straight places, as stored in results, and the reverse.
std::vector<std::uint32_t> straightVertices(const DiskChart& chart, const StraightPlaces& straight);
StraightPlaces placesOf(const DiskChart& chart, const std::vector<std::uint32_t>& vertices);

/// Counts of runs and vertices, and the deviation of a layout.
StraightReport reportStraight(const DiskChart& chart, const StraightPlaces& straight,
                              const std::vector<double>& uv);

}  // namespace abflat
