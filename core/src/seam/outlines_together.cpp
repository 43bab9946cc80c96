#include "seam/outlines_together.h"

#include <cmath>
#include <complex>
#include <limits>

namespace abflat {
namespace {

using Complex = std::complex<double>;

Complex at(const Point2& p) { return {p[0], p[1]}; }

/// The motion that takes points of b to those of a that they should meet; `turn` is 0 if there is
/// none.
struct Motion {
  Complex turn = 0, from = 0, to = 0;

  Motion(const Outline& a, const Outline& b, const OutlinePairs& pairs) {
    const auto n = static_cast<double>(pairs.size());
    for (const auto& [i, j] : pairs) {
      to += at(a[i]) / n;
      from += at(b[j]) / n;
    }
    for (const auto& [i, j] : pairs) turn += (at(a[i]) - to) * std::conj(at(b[j]) - from);
    const double size = std::sqrt(std::norm(turn));
    if (size > 0) turn /= size;
  }
  Point2 operator()(const Point2& p) const {
    const Complex q = to + turn * (at(p) - from);
    return {q.real(), q.imag()};
  }
};

}  // namespace

double hullTogether(const Outline& a, const Outline& b, const OutlinePairs& pairs) {
  const Motion motion(a, b, pairs);
  const double apart = hullArea(a) + hullArea(b);
  if (motion.turn == 0.0 || !(apart > 0)) return std::numeric_limits<double>::infinity();
  Outline both = a;
  for (const Point2& p : b) both.push_back(motion(p));
  return hullArea(std::move(both)) / apart;
}

Outline outlineTogether(const Outline& a, const Outline& b, const OutlinePairs& pairs) {
  const Motion motion(a, b, pairs);
  Outline out;
  if (motion.turn == 0.0) return out;
  const auto [firstOfA, firstOfB] = pairs.front();
  const auto [lastOfA, lastOfB] = pairs.back();
  for (BoundaryIndex i = lastOfA; i != firstOfA; i = nextAlong(i, a.size())) out.push_back(a[i]);
  for (BoundaryIndex j = firstOfB; j != lastOfB; j = nextAlong(j, b.size()))
    out.push_back(motion(b[j]));
  return out;
}

}  // namespace abflat
