#include "flatten/level_runs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/constants.h"
#include "base/point2.h"
#include "base/portable_math.h"
#include "boundary/straight_runs.h"

namespace abflat {
namespace {

constexpr double kQuarter = kPi / 2, kDegree = kPi / 180;

/// An edge of the outline in the layout.
struct RunSide {
  double angle = 0, length = 0;
};
using Sides = IdVector<BoundaryIndex, RunSide>;
/// Per edge of the outline, the direction that it stands for, in quarter turns.
using Directions = IdVector<BoundaryIndex, std::uint8_t>;

Sides sidesOf(const DiskChart& chart, const std::vector<double>& uv) {
  Sides out;
  for (const BoundaryIndex i : chart.boundary.ids()) {
    const Point2 a = pointAt(uv, chart.boundaryVertex(i));
    const Point2 b = pointAt(uv, chart.boundaryVertex(chart.after(i)));
    const double x = b[0] - a[0], y = b[1] - a[1];
    out.push_back({portable::atan2(y, x), portable::hypot(x, y)});
  }
  return out;
}

/// To -pi..pi.
double wrapped(double angle) { return angle - 2 * kPi * std::round(angle / (2 * kPi)); }

/// The mean direction of the edges modulo quarter turns, and how much they agree: 0 to 1.
struct Axis {
  double angle = 0, agreement = 0;
};
Axis axisOf(const Sides& sides, double length) {
  double x = 0, y = 0;
  for (const RunSide& side : sides) {
    const portable::SinCos by = portable::sinCos(4 * side.angle);
    x += side.length * by.cos;
    y += side.length * by.sin;
  }
  return {portable::atan2(y, x) / 4, portable::hypot(x, y) / length};
}

/// Gives each edge the direction that it deviates from least, where each corner costs something.
/// Viterbi's algorithm, from the longest edge round. Empty if the corners do not close a polygon.
class Polygon {
 public:
  Polygon(const DiskChart& chart, const Sides& sides, double length)
      : chart_(chart), sides_(sides), corner_(kCorner * length) {}

  Directions directions() {
    const BoundaryIndex first = start();
    const std::uint8_t begin = nearest(first);
    std::array<double, 4> cost;
    cost.fill(std::numeric_limits<double>::infinity());
    cost[begin] = 0;
    for (BoundaryIndex i = chart_.after(first); i != first; i = chart_.after(i))
      cost = step(i, cost);
    closeTo(begin, cost);
    return trace(first, begin);
  }

 private:
  static constexpr double kCorner = 0.01;

  double deviation(BoundaryIndex i, int direction) const {
    return wrapped(sides_[i].angle - direction * kQuarter);
  }

  std::uint8_t nearest(BoundaryIndex i) const {
    std::uint8_t out = 0;
    for (std::uint8_t d = 1; d < 4; ++d)
      if (std::abs(deviation(i, d)) < std::abs(deviation(i, out))) out = d;
    return out;
  }

  /// The longest edge of those whose direction is clear.
  BoundaryIndex start() const {
    BoundaryIndex out(0);
    double most = -1;
    for (const BoundaryIndex i : sides_.ids()) {
      const double clear = sides_[i].length * (kQuarter / 2 - std::abs(deviation(i, nearest(i))));
      if (clear <= most) continue;
      most = clear;
      out = i;
    }
    return out;
  }

  std::array<double, 4> step(BoundaryIndex i, const std::array<double, 4>& before) {
    std::array<double, 4> out{};
    std::array<std::uint8_t, 4> from{};
    for (int d = 0; d < 4; ++d) {
      const double own = sides_[i].length * deviation(i, d) * deviation(i, d);
      out[d] = std::numeric_limits<double>::infinity();
      for (const int turn : {0, 1, 3}) {
        const int k = (d + turn) % 4;
        const double cost = before[k] + own + (turn == 0 ? 0 : corner_);
        if (!(cost < out[d])) continue;
        out[d] = cost;
        from[d] = static_cast<std::uint8_t>(k);
      }
    }
    from_.push_back(from);
    return out;
  }

  void closeTo(std::uint8_t begin, const std::array<double, 4>& cost) {
    double least = std::numeric_limits<double>::infinity();
    for (const int turn : {0, 1, 3}) {
      const int k = (begin + turn) % 4;
      const double now = cost[k] + (turn == 0 ? 0 : corner_);
      if (!(now < least)) continue;
      least = now;
      last_ = static_cast<std::uint8_t>(k);
    }
  }

  Directions trace(BoundaryIndex first, std::uint8_t begin) const {
    Directions out(sides_.size(), begin);
    std::uint8_t now = last_;
    BoundaryIndex i = chart_.before(first);
    for (std::size_t k = from_.size(); k-- > 0; i = chart_.before(i)) {
      out[i] = now;
      now = from_[k][now];
    }
    int turns = 0;
    for (const BoundaryIndex j : out.ids()) {
      const int turn = (out[j] - out[chart_.before(j)] + 4) % 4;
      turns += turn == 3 ? -1 : turn;
    }
    return turns == 4 ? out : Directions();
  }

  const DiskChart& chart_;
  const Sides& sides_;
  const double corner_;
  std::vector<std::array<std::uint8_t, 4>> from_;
  std::uint8_t last_ = 0;
};

/// Leaves out the runs that cannot be straight because a triangle would lose its area.
std::vector<LevelRun> withoutChords(const DiskChart& chart, std::vector<LevelRun> runs) {
  StraightPlaces straight(chart.boundary.size(), 0);
  IdVector<BoundaryIndex, std::size_t> runAt(chart.boundary.size(), runs.size());
  for (std::size_t k = 0; k < runs.size(); ++k)
    for (BoundaryIndex i = chart.after(runs[k].from); i != runs[k].to; i = chart.after(i)) {
      straight[i] = 1;
      runAt[i] = k;
    }
  std::vector<std::uint8_t> isFree(runs.size(), 1);
  for (const FlatChord& chord : flatChords(chart, straight))
    isFree[runAt[chart.after(chord.from)]] = 0;
  std::vector<LevelRun> out;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (isFree[k]) out.push_back(runs[k]);
  return out;
}

struct Deviations {
  double length = 0, square = 0, before = 0;
};

/// How far the edges of a run deviate from its direction.
Deviations deviationsOf(const DiskChart& chart, const Sides& sides, const Directions& directions,
                        const LevelRun& run) {
  Deviations out;
  for (BoundaryIndex i = run.from; i != run.to; i = chart.after(i)) {
    const double off = wrapped(sides[i].angle - directions[i] * kQuarter);
    out.length += sides[i].length;
    out.square += sides[i].length * off * off;
    if (std::abs(off) <= kDegree) out.before += sides[i].length;
  }
  return out;
}

}  // namespace

LevelRuns findLevelRuns(const DiskChart& chart, const std::vector<double>& uv,
                        const LevelLimits& limits) {
  LevelRuns out;
  Sides sides = sidesOf(chart, uv);
  double length = 0;
  for (const RunSide& side : sides) length += side.length;
  if (!(length > 0) || sides.size() < 4) return out;
  const Axis axis = axisOf(sides, length);
  if (axis.agreement < limits.leastAgreement) return out;
  out.turn = -axis.angle;
  for (RunSide& side : sides) side.angle -= axis.angle;
  const Directions directions = Polygon(chart, sides, length).directions();
  if (directions.empty()) return out;
  for (const BoundaryIndex i : directions.ids()) {
    if (directions[i] == directions[chart.before(i)]) continue;
    LevelRun run{i, chart.after(i), static_cast<std::uint8_t>(1 - directions[i] % 2)};
    while (directions[run.to] == directions[i]) run.to = chart.after(run.to);
    const Deviations own = deviationsOf(chart, sides, directions, run);
    out.before += own.before / length;
    if (own.square <= limits.mostDeviation * limits.mostDeviation * own.length)
      out.runs.push_back(run);
  }
  out.runs = withoutChords(chart, std::move(out.runs));
  for (const LevelRun& run : out.runs)
    out.share += deviationsOf(chart, sides, directions, run).length / length;
  return out;
}

}  // namespace abflat
