#include "check/orientation.h"

#include <array>
#include <cmath>
#include <limits>

namespace abflat {
namespace {

/// A sum of doubles kept exactly as an expansion of non-overlapping parts, smallest first (Shewchuk
/// 1997).
class ExactSum {
 public:
  void add(double x) {
    unsigned kept = 0;
    for (unsigned i = 0; i < size_; ++i) {
      const double sum = x + parts_[i], virtualX = sum - parts_[i];
      const double low = (x - virtualX) + (parts_[i] - (sum - virtualX));
      if (low != 0) parts_[kept++] = low;
      x = sum;
    }
    parts_[kept] = x;
    size_ = kept + 1;
  }
  void addProduct(double x, double y) {
    const double product = x * y;
    add(std::fma(x, y, -product));
    add(product);
  }
  int sign() const {
    for (unsigned i = size_; i-- > 0;)
      if (parts_[i] != 0) return parts_[i] > 0 ? 1 : -1;
    return 0;
  }

 private:
  std::array<double, 13> parts_{};
  unsigned size_ = 0;
};

}  // namespace

int orientation(const double* a, const double* b, const double* c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]);
  const double det = left - right;
  // Shewchuk's first filter, (3 + 16 eps) eps with eps = half an ulp of 1.
  constexpr double kEps = std::numeric_limits<double>::epsilon() / 2;
  constexpr double kBound = (3 + 16 * kEps) * kEps;
  if (std::abs(det) > kBound * (std::abs(left) + std::abs(right))) return det > 0 ? 1 : -1;
  ExactSum sum;
  sum.addProduct(a[0], b[1]);
  sum.addProduct(-a[1], b[0]);
  sum.addProduct(b[0], c[1]);
  sum.addProduct(-b[1], c[0]);
  sum.addProduct(c[0], a[1]);
  sum.addProduct(-c[1], a[0]);
  return sum.sign();
}

}  // namespace abflat
