#include "boundary/untangle.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>

#include "base/constants.h"
#include "base/portable_math.h"
#include "base/stable_order.h"
#include "boundary/blamed_arc.h"

namespace abflat {
namespace {

constexpr double kStepOfT = 0.01;  ///< resolution of the global search
constexpr int kMaxRounds = 40;     ///< of local tightening
constexpr int kRelaxations = 3;    ///< bisections afterwards

/// Relative to the distortion: a smaller remaining gain is not worth further solutions.
constexpr double kNegligible = 0.002;

/// A pair of crossing edges, and what closes between them.
struct Blamed {
  Arc arc;
  std::size_t i, j;
};

/// Picks the shortest arc and then every further one, by length, that does not overlap those
/// picked, so that together they have no more vertices than the boundary. Arcs around a shorter one
/// mostly cross only because the shorter one does.
std::vector<Blamed> apart(std::vector<Blamed> blamed, std::size_t n) {
  const std::vector<std::uint32_t> order = stableOrder(
      blamed.size(),
      [&](std::uint32_t a, std::uint32_t b) { return blamed[a].arc.count < blamed[b].arc.count; });
  std::vector<std::uint8_t> isTaken(n, 0);
  std::set<std::size_t> starts;
  const auto startsWithin = [&](std::size_t from, std::size_t to) {
    const auto found = starts.lower_bound(from);
    return found != starts.end() && *found < to;
  };
  std::vector<Blamed> out;
  for (const std::uint32_t i : order) {
    const Blamed& g = blamed[i];
    const std::size_t from = g.arc.first % n, to = from + g.arc.count;
    if (isTaken[from] || isTaken[(to - 1) % n] || startsWithin(from, std::min(to, n)) ||
        (to > n && startsWithin(0, to - n)))
      continue;
    for (std::size_t k = from; k < to; ++k) isTaken[k % n] = 1;
    starts.insert(from);
    out.push_back(g);
  }
  return out;
}

/// Places of the boundary in the layout.
struct OutlinePoints {
  const DiskChart& chart;
  const std::vector<double>& uv;

  const double* operator[](std::size_t place) const {
    const BoundaryIndex i(place % chart.boundary.size());
    return &uv[2 * std::size_t{chart.boundaryVertex(i)}];
  }
};

double distance(const double* a, const double* b) {
  return portable::hypot(a[0] - b[0], a[1] - b[1]);
}

double distanceToLine(const double* p, const double* a, const double* b) {
  const double length = distance(a, b);
  const double area = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
  return length > 0 ? std::abs(area) / length : distance(p, a);
}

/// How far one of two crossing edges has to move so that they no longer cross.
double overlapDepth(const OutlinePoints& at, std::size_t i, std::size_t j) {
  const double *a = at[i], *b = at[i + 1], *c = at[j], *d = at[j + 1];
  return std::min(std::min(distanceToLine(a, c, d), distanceToLine(b, c, d)),
                  std::min(distanceToLine(c, a, b), distanceToLine(d, a, b)));
}

/// The level that takes `amount` radians off the angles above it. It is at least pi, and that far
/// below 2 pi, which no valid layout reaches.
double capLevel(std::vector<double> angles, double amount) {
  sortStably(angles, std::greater<>());
  double above = 0, level = kPi;
  for (std::size_t k = 0; k < angles.size() && angles[k] > level; ++k) {
    above += angles[k];
    level = std::max(kPi, (above - amount) / static_cast<double>(k + 1));
  }
  return std::min(level, 2 * kPi - amount);
}

/// Tightens the bounds of the arcs that cross; a vertex is pushed harder each time it is tightened.
class Tightening {
 public:
  Tightening(const ChartFlattener& flattener, std::size_t count)
      : flattener_(flattener), chart_(flattener.chart()), push_(count, 1) {}

  BoundaryBounds next(const Attempt& from) {
    const IdVector<BoundaryIndex, double> angle = boundaryAngles(chart_, from.solution);
    const std::vector<double> turned = turnedAlong(angle);
    std::vector<Blamed> blamed;
    for (const auto& [i, j] : from.validity.crossings.first)
      blamed.push_back({blamedArc(i, j, turned), i, j});
    BoundaryBounds t = from.t;
    for (const Blamed& g : apart(std::move(blamed), angle.size())) tightenArc(g, from, angle, t);
    for (const BoundaryIndex i : t.ids())
      if (t[i] < from.t[i]) push_[i] *= kHarder;
    return t;
  }

 private:
  static constexpr double kHarder = 3;
  /// Radians of turning taken out of an arc in one round.
  static constexpr double kLeastPush = 1e-4, kMostPush = 0.5;

  /// Both arcs open by about the amount they are turned times their length.
  double amountFor(const Blamed& g, const Attempt& from) const {
    const std::size_t n = push_.size();
    const OutlinePoints at{chart_, from.uv};
    double reach = 0, push = 1;
    for (std::size_t k = 0; k < g.arc.count; ++k) {
      const BoundaryIndex place = g.arc.at(k, n);
      reach = std::max(reach, distance(at[place], at[g.i]));
      push = std::max(push, push_[place]);
    }
    const double depth = overlapDepth(at, g.i, g.j) + flattener_.leastDistance(from.uv);
    return std::clamp(push * (reach > 0 ? depth / reach : kMostPush), kLeastPush, kMostPush);
  }

  void tightenArc(const Blamed& g, const Attempt& from,
                  const IdVector<BoundaryIndex, double>& angle, BoundaryBounds& t) const {
    const std::size_t n = angle.size();
    std::vector<double> inArc(g.arc.count);
    for (std::size_t k = 0; k < g.arc.count; ++k) inArc[k] = angle[g.arc.at(k, n)];
    const double level = capLevel(inArc, amountFor(g, from));
    for (std::size_t k = 0; k < g.arc.count; ++k) {
      double& bound = t[g.arc.at(k, n)];
      if (inArc[k] > level) bound = std::min(bound, level / kPi);
    }
  }

  const ChartFlattener& flattener_;
  const DiskChart& chart_;
  IdVector<BoundaryIndex, double> push_;
};

BoundaryBounds lowered(BoundaryBounds t, double limit) {
  for (double& x : t) x = std::min(x, limit);
  return t;
}

BoundaryBounds between(const BoundaryBounds& a, const BoundaryBounds& b, double share) {
  BoundaryBounds out(a.size());
  for (const BoundaryIndex i : a.ids())
    out[i] = std::min(a[i], 2.0) + share * (std::min(b[i], 2.0) - std::min(a[i], 2.0));
  return out;
}

}  // namespace

Attempt untangleGlobal(ChartFlattener& flattener, const Attempt& crossing, double distortionLimit) {
  const BoundaryBounds& asked = crossing.t;
  Attempt invalid = crossing;
  std::optional<Attempt> valid;
  double high = std::min(2.0, *std::max_element(asked.begin(), asked.end())), low = 0;
  // Lower in growing steps, then bisect.
  for (double drop = 0.1; !valid && high > 1; drop *= 2) {
    const double t = std::max(1.0, high - drop);
    Attempt a = flattener.attempt(lowered(asked, t), &invalid);
    if (a.valid()) {
      valid = std::move(a);
      low = t;
      break;
    }
    if (a.isCancelled() || a.isGivenUp() || a.distortion.angular > distortionLimit) return a;
    invalid = std::move(a);
    high = t;
  }
  if (!valid) return invalid;
  while (high - low > kStepOfT * 1.0001) {
    if (invalid.distortion.angular > distortionLimit) break;
    // On the grid of hundredths, so that the answer is a number that a person would type.
    double t = std::round((low + high) / 2 / kStepOfT) * kStepOfT;
    if (t <= low || t >= high) break;
    Attempt a = flattener.attempt(lowered(asked, t), &*valid);
    if (a.isCancelled()) return a;
    if (a.isGivenUp()) break;
    if (a.valid()) {
      valid = std::move(a);
      low = t;
    } else {
      invalid = std::move(a);
      high = t;
    }
  }
  return std::move(*valid);
}

Attempt untangleLocal(ChartFlattener& flattener, const Attempt& crossing) {
  Attempt last = crossing;
  Tightening tightening(flattener, crossing.t.size());
  for (int round = 0; round < kMaxRounds; ++round) {
    Attempt next = flattener.attempt(tightening.next(last), &last);
    if (next.isCancelled() || next.isGivenUp()) return next;
    if (next.valid()) {
      Attempt best = std::move(next);
      BoundaryBounds loose = last.t;
      const double atMostGained = (1 + kNegligible) * last.distortion.angular;
      for (int i = 0; i < kRelaxations && best.distortion.angular > atMostGained; ++i) {
        const BoundaryBounds middle = between(loose, best.t, 0.5);
        Attempt a = flattener.attempt(middle, &best);
        if (a.isCancelled()) return a;
        if (a.isGivenUp()) break;
        if (a.valid())
          best = std::move(a);
        else
          loose = middle;
      }
      return best;
    }
    // Once triangles flip, tightening further does not help.
    if (next.validity.flippedTriangles > 0 || !next.converged()) return next;
    last = std::move(next);
  }
  return last;
}

}  // namespace abflat
