#pragma once

#include <array>
#include <cmath>

namespace abflat {

/// A sum of doubles kept exactly as an expansion of non-overlapping parts, smallest first (Shewchuk
/// 1997). Capacity: one
/// more than the number of doubles added.
template <unsigned Capacity>
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
  /// A product of four factors takes eight doubles.
  void addProduct(double a, double b, double c, double d) {
    const double ab = a * b, cd = c * d;
    const double abLow = std::fma(a, b, -ab), cdLow = std::fma(c, d, -cd);
    addProduct(abLow, cdLow);
    addProduct(abLow, cd);
    addProduct(ab, cdLow);
    addProduct(ab, cd);
  }
  int sign() const {
    for (unsigned i = size_; i-- > 0;)
      if (parts_[i] != 0) return parts_[i] > 0 ? 1 : -1;
    return 0;
  }

 private:
  std::array<double, Capacity> parts_{};
  unsigned size_ = 0;
};

}  // namespace abflat
