#include "seam/room.h"

#include <cmath>
#include <complex>
#include <limits>

namespace abflat {
namespace {

using Complex = std::complex<double>;

Complex at(const Point2& p) { return {p[0], p[1]}; }

/// The motion that takes points of b to those of a that they are to meet; `turn` is 0 where there
/// is none.
struct Motion {
  Complex turn = 0, from = 0, to = 0;

  Motion(const std::vector<Point2>& a, const std::vector<Point2>& b,
         const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
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

double roomTogether(const std::vector<Point2>& a, const std::vector<Point2>& b,
                    const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
  const Motion motion(a, b, pairs);
  const double apart = hullArea(a) + hullArea(b);
  if (motion.turn == 0.0 || !(apart > 0)) return std::numeric_limits<double>::infinity();
  std::vector<Point2> both = a;
  for (const Point2& p : b) both.push_back(motion(p));
  return hullArea(std::move(both)) / apart;
}

std::vector<Point2> outlineTogether(const std::vector<Point2>& a, const std::vector<Point2>& b,
                                    const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
  const Motion motion(a, b, pairs);
  std::vector<Point2> out;
  if (motion.turn == 0.0) return out;
  for (std::size_t i = pairs.back().first; i != pairs.front().first; i = (i + 1) % a.size())
    out.push_back(a[i]);
  for (std::size_t j = pairs.front().second; j != pairs.back().second; j = (j + 1) % b.size())
    out.push_back(motion(b[j]));
  return out;
}

}  // namespace abflat
