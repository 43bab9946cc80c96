#include "exact/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "exact/exact_sum.h"

namespace abflat {
namespace {

/// (high + low) * 2^exponent; low is what high lacks of the product, which has 106 digits.
struct Product {
  double high = 0, low = 0;
  int exponent = 0;
};

Product productOf(double x, double y) {
  Product out;
  int ofX = 0, ofY = 0;
  const double fractionX = std::frexp(x, &ofX), fractionY = std::frexp(y, &ofY);
  out.high = fractionX * fractionY;
  out.low = std::fma(fractionX, fractionY, -out.high);
  out.exponent = ofX + ofY;
  return out;
}

/// Products are added up in runs of similar exponents, the largest first: unless the sum of a run
/// is zero, those after a gap of more digits than a product has cannot change its sign.
int signOfSum(std::array<Product, 6> products) {
  constexpr int kGap = 120;
  // There are few, and std::sort would take more of the module than all else here.
  for (std::size_t i = 1; i < products.size(); ++i)
    for (std::size_t k = i; k > 0 && products[k - 1].exponent < products[k].exponent; --k)
      std::swap(products[k - 1], products[k]);
  const auto* end = products.data() + products.size();
  for (const Product* next = products.data(); next != end;) {
    ExactSum<13> sum;
    const Product* first = next;
    do {
      sum.add(std::ldexp(next->low, next->exponent - first->exponent));
      sum.add(std::ldexp(next->high, next->exponent - first->exponent));
      ++next;
    } while (next != end && (next - 1)->exponent - next->exponent <= kGap);
    if (sum.sign() != 0) return sum.sign();
  }
  return 0;
}

/// Whatever the exponents are.
int orientationOfAny(const double* a, const double* b, const double* c) {
  return signOfSum({productOf(a[0], b[1]), productOf(-a[1], b[0]), productOf(b[0], c[1]),
                    productOf(-b[1], c[0]), productOf(c[0], a[1]), productOf(-c[1], a[0])});
}

/// Whether products of these neither overflow nor lose digits to underflow.
bool areProductsSafe(const double* p) {
  constexpr double kLeast = 0x1p-450, kMost = 0x1p500;
  const auto isSafe = [](double x) {
    return x == 0 || (std::abs(x) >= kLeast && std::abs(x) <= kMost);
  };
  return isSafe(p[0]) && isSafe(p[1]);
}

}  // namespace

int orientation(const double* a, const double* b, const double* c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]);
  const double det = left - right;
  // Shewchuk's first filter, (3 + 16 eps) eps with eps = half an ulp of 1, and more than what
  // underflow takes.
  constexpr double kEps = std::numeric_limits<double>::epsilon() / 2;
  constexpr double kBound = (3 + 16 * kEps) * kEps, kUnderflow = 0x1p-1000;
  if (std::abs(det) > kBound * (std::abs(left) + std::abs(right)) + kUnderflow)
    return det > 0 ? 1 : -1;
  if (!areProductsSafe(a) || !areProductsSafe(b) || !areProductsSafe(c))
    return orientationOfAny(a, b, c);
  ExactSum<13> sum;
  sum.addProduct(a[0], b[1]);
  sum.addProduct(-a[1], b[0]);
  sum.addProduct(b[0], c[1]);
  sum.addProduct(-b[1], c[0]);
  sum.addProduct(c[0], a[1]);
  sum.addProduct(-c[1], a[0]);
  return sum.sign();
}

}  // namespace abflat
