#include "unwrap/straight_seams.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"

namespace abflat {
namespace {

/// In radians: how much the boundary turns at a corner at least, and how much a run without corners
/// may turn in total.
constexpr double kCorner = kPi / 4;
constexpr double kMostTurn = kPi / 2;

/// Whether the seam, or the boundary of the surface, goes on from one half-edge to the next.
bool goesOn(const Surface& surface, const Outlines& outlines, SurfaceCorner from,
            SurfaceCorner to) {
  const SurfaceCorner behind = surface.table.twin[from], ahead = surface.table.twin[to];
  if (!behind.exists() || !ahead.exists()) return behind == ahead;
  return behind != to && outlines[ahead] == behind;
}

/// Whether it does, for each place of the chart's boundary.
StraightPlaces goOn(const Surface& surface, const ChartTopology& chart, const Outlines& outlines) {
  StraightPlaces out;
  ChartCorner before = chart.boundary.back();
  for (const ChartCorner h : chart.boundary) {
    out.push_back(goesOn(surface, outlines, chart.onSurface(before), chart.onSurface(h)));
    before = h;
  }
  return out;
}

/// How much the boundary turns to the left on the surface, at each place.
using Turns = IdVector<BoundaryIndex, double>;
Turns turns(const DiskChart& chart) {
  Turns out;
  for (const ChartCorner h : chart.boundary) {
    double turn = kPi;
    for (ChartCorner c = h; c.exists(); c = rotateCounterClockwise(chart.twin, c))
      turn -= chart.angles[triangleOf(c)][placeInTriangle(c)];
    out.push_back(turn);
  }
  return out;
}

/// Calls visit(places) for each run of straight places.
template <class Visit>
void forEachRun(const StraightPlaces& straight, const Visit& visit) {
  const std::size_t n = straight.size();
  const auto first = std::find(straight.begin(), straight.end(), 0) - straight.begin();
  const auto start = static_cast<std::size_t>(first);
  std::vector<BoundaryIndex> run;
  for (std::size_t i = start; i < start + n; ++i) {
    const BoundaryIndex place(i % n);
    if (straight[place] != 0) run.push_back(place);
    const bool isEnd = straight[place] == 0 || i + 1 == start + n;
    if (!isEnd || run.empty()) continue;
    visit(run);
    run.clear();
  }
}

/// Releases the runs that turn by more than `most`. Returns the largest turn of the others.
double releaseTurning(const Turns& turn, double most, StraightPlaces& straight) {
  double left = 0;
  const StraightPlaces before = straight;
  forEachRun(before, [&](const std::vector<BoundaryIndex>& run) {
    double sum = 0;
    for (const BoundaryIndex i : run) sum += turn[i];
    if (std::abs(sum) <= most)
      left = std::max(left, std::abs(sum));
    else
      for (const BoundaryIndex i : run) straight[i] = 0;
  });
  return left;
}

/// Releases, between the ends of each chord, the place that turns most.
void releaseAtChords(const DiskChart& chart, const Turns& turn, StraightPlaces& straight) {
  for (;;) {
    const std::vector<FlatChord> chords = flatChords(chart, straight);
    if (chords.empty()) return;
    for (const FlatChord& chord : chords) {
      BoundaryIndex sharpest = chart.after(chord.from);
      bool isOpen = false;  // released for an earlier chord
      for (BoundaryIndex i = sharpest; i != chord.to; i = chart.after(i)) {
        isOpen = isOpen || straight[i] == 0;
        if (std::abs(turn[i]) > std::abs(turn[sharpest])) sharpest = i;
      }
      if (!isOpen) straight[sharpest] = 0;
    }
  }
}

}  // namespace

Outlines findOutlines(const Surface& surface, const IdVector<SurfaceCorner, std::uint8_t>& isCut) {
  Outlines out(isCut.size());
  for (const SurfaceCorner h : isCut.ids()) {
    if (isCut[h] == 0) continue;
    out[h] = nextCorner(h);
    while (isCut[out[h]] == 0) out[h] = nextCorner(surface.table.twin[out[h]]);
  }
  return out;
}

Outlines findOutlines(const Surface& surface, const ChartSet& set) {
  IdVector<SurfaceCorner, std::uint8_t> isCut(surface.table.twin.size(), 0);
  for (const ChartId i : set.ids()) {
    const ChartTopology chart = set.topology(i);
    const IdRange<ChartCorner> corners = chart.surfaceCorners();
    for (const ChartCorner h : corners) isCut[chart.onSurface(h)] = chart.twin[h] >= corners.size();
  }
  return findOutlines(surface, isCut);
}

bool hasSameEnds(const CutMesh& mesh, ChartId chart, const Outlines& a, const Outlines& b) {
  const ChartTopology topology = mesh.set.topology(chart);
  return goOn(mesh.map.surface(), topology, a) == goOn(mesh.map.surface(), topology, b);
}

IdVector<ChartId, StraightSeams> straightSeams(
    const Surface& surface, const ChartSet& set, const Outlines& outlines,
    const IdVector<SurfaceTriangle, std::uint8_t>& isFixed) {
  IdVector<ChartId, StraightSeams> out(set.size());
  for (const ChartId i : set.ids()) {
    const ChartTopology topology = set.topology(i);
    if (!isFixed.empty() && isFixed[topology.triangles.front()]) continue;
    const DiskChart chart = set.chart(i);
    const Turns turn = turns(chart);
    StraightPlaces& places = out[i].places;
    places = goOn(surface, topology, outlines);
    for (const BoundaryIndex k : places.ids())
      if (std::abs(turn[k]) > kCorner) places[k] = 0;
    const std::size_t ends = placesThatTurn(chart, places);
    double most = releaseTurning(turn, kMostTurn, places);
    // Release the sharpest run first, as a whole: a bend in its middle would be no better.
    while (isTooStraight(places)) most = releaseTurning(turn, std::nextafter(most, -1), places);
    releaseAtChords(chart, turn, places);
    out[i].released = placesThatTurn(chart, places) - ends;
  }
  return out;
}

}  // namespace abflat
