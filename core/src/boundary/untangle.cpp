#include "boundary/untangle.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "angle/constants.h"

namespace abflat {
namespace {

constexpr double kStepOfT = 0.01;  ///< resolution of the global search
constexpr int kMaxRounds = 40;     ///< of local tightening
constexpr int kRelaxations = 3;    ///< bisections afterwards

bool cancelled(const Attempt& a) { return a.solution.cancelled; }

/// Interior angles at the boundary vertices, radians, in the order of chart.boundary.
std::vector<double> boundaryAngles(const DiskChart& chart, const AngleSolution& s) {
  std::vector<double> sum(chart.vertexCount(), 0), out;
  for (std::size_t c = 0; c < s.angles.size(); ++c) sum[chart.vertexOfCorner[c]] += s.angles[c];
  for (const std::uint32_t h : chart.boundary) out.push_back(sum[chart.vertexOfCorner[h]]);
  return out;
}

/// A run of boundary vertices first, first + 1, ... (cyclic).
struct Arc {
  std::size_t first, count;
};

/// Of the two arcs between crossing edges i < j, the one that turns clockwise more: it closes a
/// loop the wrong way round, or folds two parts of the boundary over each other. `turned` holds
/// prefix sums of pi - angle.
Arc guiltyArc(std::size_t i, std::size_t j, const std::vector<double>& turned) {
  const std::size_t n = turned.size() - 1;
  const double inner = turned[j + 1] - turned[i + 1];
  return inner < turned[n] - inner ? Arc{i + 1, j - i} : Arc{j + 1, n - (j - i)};
}

/// The level that takes `amount` radians off the angles above it: at least pi, and below 2 pi,
/// which no valid layout has.
double capLevel(std::vector<double> angles, double amount) {
  constexpr double kBelowFullTurn = 1.98 * kPi;
  std::sort(angles.begin(), angles.end(), std::greater<>());
  double above = 0, level = kPi;
  for (std::size_t k = 0; k < angles.size() && angles[k] > level; ++k) {
    above += angles[k];
    level = std::max(kPi, (above - amount) / static_cast<double>(k + 1));
  }
  return std::min(level, kBelowFullTurn);
}

/// Tightens the bounds of the arcs that cross: each time a vertex is tightened it is pushed harder.
class Tightening {
 public:
  Tightening(const DiskChart& chart, std::size_t count) : chart_(chart), push_(count, kFirstPush) {}

  std::vector<double> next(const Attempt& from) {
    const std::vector<double> angle = boundaryAngles(chart_, from.solution);
    const std::size_t n = angle.size();
    std::vector<double> turned(n + 1, 0);
    for (std::size_t k = 0; k < n; ++k) turned[k + 1] = turned[k] + kPi - angle[k];
    std::vector<double> t = from.t;
    for (const auto& [i, j] : from.validity.crossings.first)
      tightenArc(guiltyArc(i, j, turned), angle, t);
    for (std::size_t v = 0; v < n; ++v)
      if (t[v] < from.t[v]) push_[v] *= kHarder;
    return t;
  }

 private:
  static constexpr double kFirstPush = 0.05;  ///< radians of turning taken out of an arc
  static constexpr double kHarder = 1.3;

  void tightenArc(const Arc& arc, const std::vector<double>& angle, std::vector<double>& t) const {
    const std::size_t n = angle.size();
    std::vector<double> inArc(arc.count);
    double amount = 0;
    for (std::size_t k = 0; k < arc.count; ++k) {
      inArc[k] = angle[(arc.first + k) % n];
      amount = std::max(amount, push_[(arc.first + k) % n]);
    }
    const double level = capLevel(inArc, amount);
    for (std::size_t k = 0; k < arc.count; ++k)
      if (inArc[k] > level) t[(arc.first + k) % n] = std::min(t[(arc.first + k) % n], level / kPi);
  }

  const DiskChart& chart_;
  std::vector<double> push_;  ///< per boundary vertex
};

std::vector<double> between(const std::vector<double>& a, const std::vector<double>& b,
                            double share) {
  std::vector<double> out(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    out[i] = std::min(a[i], 2.0) + share * (std::min(b[i], 2.0) - std::min(a[i], 2.0));
  return out;
}

}  // namespace

Attempt untangleGlobal(ChartFlattener& flattener, const Attempt& crossing, double distortionLimit) {
  const std::size_t n = crossing.t.size();
  Attempt invalid = crossing, valid;
  double high = 2, low = 0;
  bool found = false;
  // Down in growing steps, then bisection.
  for (double drop = 0.1; !found && high > 1; drop *= 2) {
    const double t = std::max(1.0, high - drop);
    Attempt a = flattener.attempt(std::vector<double>(n, t), &invalid);
    if (cancelled(a) || (found = a.valid())) {
      valid = std::move(a);
      low = t;
      break;
    }
    if (a.distortion.angular > distortionLimit) return a;
    invalid = std::move(a);
    high = t;
  }
  if (!found || cancelled(valid)) return found || cancelled(valid) ? valid : invalid;
  while (high - low > kStepOfT * 1.0001) {
    if (invalid.distortion.angular > distortionLimit) break;
    // On the grid of hundredths, so that the answer is a number a person would type.
    double t = std::round((low + high) / 2 / kStepOfT) * kStepOfT;
    if (t <= low || t >= high) break;
    Attempt a = flattener.attempt(std::vector<double>(n, t), &valid);
    if (cancelled(a)) return a;
    if (a.valid()) {
      valid = std::move(a);
      low = t;
    } else {
      invalid = std::move(a);
      high = t;
    }
  }
  return valid;
}

Attempt untangleLocal(ChartFlattener& flattener, const Attempt& crossing) {
  Attempt last = crossing;
  Tightening tightening(flattener.chart(), crossing.t.size());
  for (int round = 0; round < kMaxRounds; ++round) {
    Attempt next = flattener.attempt(tightening.next(last), &last);
    if (cancelled(next)) return next;
    if (next.valid()) {
      Attempt best = std::move(next);
      std::vector<double> loose = last.t;
      for (int i = 0; i < kRelaxations; ++i) {
        const std::vector<double> middle = between(loose, best.t, 0.5);
        Attempt a = flattener.attempt(middle, &best);
        if (cancelled(a)) return a;
        if (a.valid())
          best = std::move(a);
        else
          loose = middle;
      }
      return best;
    }
    // Where the triangles are no longer fine, tightening further does not help.
    if (next.validity.flippedTriangles > 0 || !next.solution.converged) return next;
    last = std::move(next);
  }
  return last;
}

}  // namespace abflat
