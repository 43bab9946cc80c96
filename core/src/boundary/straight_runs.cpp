#include "boundary/straight_runs.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/constants.h"
#include "check/validity.h"

namespace abflat {
namespace {

/// The place of each vertex on the boundary; none for interior vertices.
IdVector<ChartVertex, BoundaryIndex> placesOfVertices(const DiskChart& chart) {
  IdVector<ChartVertex, BoundaryIndex> out(chart.vertexCount());
  for (const BoundaryIndex i : chart.boundary.ids()) out[chart.boundaryVertex(i)] = i;
  return out;
}

std::string nameOf(const DiskChart& chart, BoundaryIndex place) {
  return "vertex " + std::to_string(chart.inputVertex[chart.boundaryVertex(place)]);
}

/// The boundary place of an input vertex that has exactly one.
Result<BoundaryIndex> placeOf(const DiskChart& chart, std::uint32_t vertex) {
  std::size_t count = 0;
  BoundaryIndex place;
  for (const BoundaryIndex i : chart.boundary.ids()) {
    if (chart.inputVertex[chart.boundaryVertex(i)] != InputVertex(vertex)) continue;
    place = i;
    ++count;
  }
  if (count == 1) return place;
  return Status{StatusCode::InvalidOption,
                "vertex " + std::to_string(vertex) + " ends a straight run, but " +
                    (count == 0 ? "is not on the boundary"
                                : "the boundary passes it more than once. End the run elsewhere")};
}

Status checkTurns(const DiskChart& chart, const StraightPlaces& straight) {
  if (isTooStraight(straight))
    return {StatusCode::InfeasibleBound,
            "the straight runs leave fewer than three boundary vertices for the turns of a closed "
            "boundary. Shorten a run"};
  const std::vector<FlatChord> chords = flatChords(chart, straight);
  if (chords.empty()) return {};
  const FlatChord& chord = chords.front();
  return {StatusCode::InfeasibleBound,
          "the edge from " + nameOf(chart, chord.from) + " to " + nameOf(chart, chord.to) +
              " cuts off part of a straight run, with no area between them. End a run at " +
              nameOf(chart, chart.after(chord.from))};
}

}  // namespace

Result<StraightPlaces> straightPlaces(const DiskChart& chart,
                                      const std::vector<StraightRun>& runs) {
  if (runs.empty()) return StraightPlaces{};
  StraightPlaces straight(chart.boundary.size(), 0);
  for (const StraightRun& run : runs) {
    const Result<BoundaryIndex> from = placeOf(chart, run.from), to = placeOf(chart, run.to);
    if (!from.ok()) return from.status();
    if (!to.ok()) return to.status();
    if (from.value() == to.value())
      return Status{StatusCode::InvalidOption, "a straight run begins and ends at vertex " +
                                                   std::to_string(run.from) +
                                                   ". It needs two different vertices"};
    for (BoundaryIndex i = chart.after(from.value()); i != to.value(); i = chart.after(i))
      straight[i] = 1;
  }
  if (Status s = checkTurns(chart, straight); !s.ok()) return s;
  return straight;
}

std::vector<FlatChord> flatChords(const DiskChart& chart, const StraightPlaces& straight) {
  const std::size_t n = straight.size();
  // How many straight places follow each one, at most n.
  std::vector<std::size_t> following(2 * n + 1, 0);
  for (std::size_t i = 2 * n; i-- > 0;)
    following[i] =
        straight[BoundaryIndex((i + 1) % n)] != 0 ? std::min(following[i + 1] + 1, n) : 0;
  const IdVector<ChartVertex, BoundaryIndex> place = placesOfVertices(chart);
  std::vector<FlatChord> out;
  for (const ChartCorner h : chart.corners()) {
    if (!chart.twin[h].exists()) continue;  // both half-edges of an inner edge are visited
    const BoundaryIndex from = place[chart.vertexOfCorner[h]];
    const BoundaryIndex to = place[chart.vertexOfCorner[nextCorner(h)]];
    if (!from.exists() || !to.exists()) continue;
    const std::size_t between = (to + n - from - 1) % n;
    if (between > 0 && between <= following[from]) out.push_back({from, to});
  }
  return out;
}

std::size_t placesThatTurn(const DiskChart& chart, const StraightPlaces& straight) {
  return chart.boundary.size() -
         static_cast<std::size_t>(std::count(straight.begin(), straight.end(), 1));
}

bool isTooStraight(const StraightPlaces& straight) {
  const auto held = std::count(straight.begin(), straight.end(), 1);
  return held > 0 && static_cast<std::size_t>(held) + 3 > straight.size();
}

std::vector<std::uint32_t> straightVertices(const DiskChart& chart,
                                            const StraightPlaces& straight) {
  std::vector<std::uint32_t> out;
  for (const BoundaryIndex i : straight.ids())
    if (straight[i] != 0) out.push_back(chart.boundaryVertex(i));
  return out;
}

StraightPlaces placesOf(const DiskChart& chart, const std::vector<std::uint32_t>& vertices) {
  const IdVector<ChartVertex, BoundaryIndex> place = placesOfVertices(chart);
  StraightPlaces out(chart.boundary.size(), 0);
  for (const std::uint32_t v : vertices) out[place[ChartVertex(v)]] = 1;
  return out;
}

StraightReport reportStraight(const DiskChart& chart, const StraightPlaces& straight,
                              const std::vector<double>& uv) {
  StraightReport out;
  for (const BoundaryIndex i : straight.ids()) {
    if (straight[i] == 0) continue;
    ++out.vertices;
    out.runs += straight[chart.before(i)] == 0;
    out.deviation =
        std::max(out.deviation, std::abs(boundaryAngle(chart, uv, chart.boundary[i]) - kPi));
  }
  return out;
}

}  // namespace abflat
