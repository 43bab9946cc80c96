#include "unwrap/straight_seams.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"

namespace abflat {
namespace {

/// Radians by which the boundary turns at a corner, or by which a run turns in all that is none.
constexpr double kCorner = kPi / 4;
constexpr double kMostTurn = kPi / 2;

/// Whether the seam, or the boundary of the surface, goes on from one half-edge to the next.
bool goesOn(const Surface& surface, const Outlines& outlines, SurfaceCorner from,
            SurfaceCorner to) {
  const SurfaceCorner behind = surface.table.twin[from], ahead = surface.table.twin[to];
  if (!behind.exists() || !ahead.exists()) return behind == ahead;
  return behind != to && outlines[ahead] == behind;
}

/// Per place of the chart's boundary.
std::vector<std::uint8_t> goOn(const Surface& surface, const ChartTopology& chart,
                               const Outlines& outlines) {
  std::vector<std::uint8_t> out;
  ChartCorner before = chart.boundary.back();
  for (const ChartCorner h : chart.boundary) {
    out.push_back(goesOn(surface, outlines, chart.onSurface(before), chart.onSurface(h)));
    before = h;
  }
  return out;
}

/// By how much the boundary turns on the surface at each place, to the left.
std::vector<double> turns(const DiskChart& chart) {
  std::vector<double> out;
  for (const std::uint32_t h : chart.boundary) {
    double turn = kPi;
    for (std::uint32_t c = h; c != kNone; c = rotateCounterClockwise(chart.twin, c))
      turn -= chart.angles[c / 3][c % 3];
    out.push_back(turn);
  }
  return out;
}

/// Calls visit(begin, end) for each run of straight places, which are those from begin up to end,
/// counted on beyond the last place.
template <class Visit>
void forEachRun(const StraightPlaces& straight, const Visit& visit) {
  const std::size_t n = straight.size();
  const auto first = std::find(straight.begin(), straight.end(), 0) - straight.begin();
  const auto start = static_cast<std::size_t>(first);
  if (start == n) return visit(std::size_t{0}, n);
  for (std::size_t i = start; i < start + n; ++i) {
    if (straight[i % n] == 0) continue;
    std::size_t end = i;
    while (straight[end % n] != 0) ++end;
    visit(i, end);
    i = end;
  }
}

/// The runs that turn by more than `most`, and how much the others turn at most.
double releaseTurning(const std::vector<double>& turn, double most, StraightPlaces& straight) {
  const std::size_t n = straight.size();
  double left = 0;
  const StraightPlaces before = straight;
  forEachRun(before, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += turn[i % n];
    if (std::abs(sum) <= most)
      left = std::max(left, std::abs(sum));
    else
      for (std::size_t i = begin; i < end; ++i) straight[i % n] = 0;
  });
  return left;
}

/// Of the places between the ends of each chord the one that turns most.
void releaseAtChords(const DiskChart& chart, const std::vector<double>& turn,
                     StraightPlaces& straight) {
  const std::size_t n = straight.size();
  for (;;) {
    const std::vector<FlatChord> chords = flatChords(chart, straight);
    if (chords.empty()) return;
    for (const FlatChord& chord : chords) {
      std::size_t sharpest = (chord.from + 1) % n;
      bool isOpen = false;  // by an earlier chord
      for (std::size_t i = sharpest; i != chord.to; i = (i + 1) % n) {
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
    const std::vector<double> turn = turns(chart);
    StraightPlaces& places = out[i].places;
    places = goOn(surface, topology, outlines);
    for (std::size_t k = 0; k < places.size(); ++k)
      if (std::abs(turn[k]) > kCorner) places[k] = 0;
    const std::size_t ends = placesThatTurn(chart, places);
    double most = releaseTurning(turn, kMostTurn, places);
    // The sharpest run first, all of it: a bend in its middle would be no better.
    while (isTooStraight(places)) most = releaseTurning(turn, std::nextafter(most, -1), places);
    releaseAtChords(chart, turn, places);
    out[i].released = placesThatTurn(chart, places) - ends;
  }
  return out;
}

}  // namespace abflat
