#include "seam/room.h"

#include <cmath>
#include <complex>
#include <limits>

namespace abflat {

double roomTogether(const std::vector<Point2>& a, const std::vector<Point2>& b,
                    const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
  using Complex = std::complex<double>;
  const auto at = [](const Point2& p) { return Complex(p[0], p[1]); };
  const auto n = static_cast<double>(pairs.size());
  Complex meanA = 0, meanB = 0, turn = 0;
  for (const auto& [i, j] : pairs) {
    meanA += at(a[i]) / n;
    meanB += at(b[j]) / n;
  }
  for (const auto& [i, j] : pairs) turn += (at(a[i]) - meanA) * std::conj(at(b[j]) - meanB);
  const double size = std::sqrt(std::norm(turn)), apart = hullArea(a) + hullArea(b);
  if (!(size > 0) || !(apart > 0)) return std::numeric_limits<double>::infinity();
  turn /= size;
  std::vector<Point2> both = a;
  for (const Point2& p : b) {
    const Complex q = meanA + turn * (at(p) - meanB);
    both.push_back({q.real(), q.imag()});
  }
  return hullArea(std::move(both)) / apart;
}

}  // namespace abflat
