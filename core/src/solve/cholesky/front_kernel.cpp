#include "solve/cholesky/front_kernel.h"

#include <cmath>

namespace abflat {
namespace {

constexpr std::size_t kSliver = 4;     ///< rows in a sliver
constexpr std::size_t kBlock = 128;    ///< columns that are eliminated together
constexpr std::size_t kMaxStrip = 16;  ///< rows in the longest strip

constexpr std::size_t roundUp(std::size_t rows) { return (rows + kSliver - 1) / kSliver * kSliver; }

/// The columns that are eliminated together.
struct Block {
  std::size_t begin, columns;  ///< in the front
  double* at;                  ///< its square on the diagonal
  std::size_t stride;
  double* sign;      ///< per column
  double* inverse;   ///< per column: S / L
  double* diagonal;  ///< slivers of L11
  double* strip;     ///< the current one
  double* slivers;   ///< of L21: of the rows in the panel, then of the others
  const double* leastPivot;
  bool allowNegative;
  PivotFailure failure;
};

bool acceptPivot(Block& b, std::size_t column, double pivot) {
  const double size = std::abs(pivot);
  if (!(size > b.leastPivot[column]) || !std::isfinite(size) || (pivot < 0 && !b.allowNegative)) {
    b.failure = {b.begin + column, pivot};
    return false;
  }
  b.sign[column] = pivot < 0 ? -1 : 1;
  b.inverse[column] = b.sign[column] / std::sqrt(size);
  return true;
}

namespace two {
#define ABFLAT_LANES 2
#define ABFLAT_TARGET
constexpr std::size_t kOneVector = 2;  // a strip has four rows at least, those of a sliver
#include "solve/cholesky/front_kernel.inc"
#undef ABFLAT_LANES
#undef ABFLAT_TARGET
}  // namespace two

#ifdef __x86_64__
namespace four {
#define ABFLAT_LANES 4
#define ABFLAT_TARGET __attribute__((target("avx2")))
constexpr std::size_t kOneVector = 1;
#include "solve/cholesky/front_kernel.inc"
#undef ABFLAT_LANES
#undef ABFLAT_TARGET
}  // namespace four

namespace eight {
#define ABFLAT_LANES 8
#define ABFLAT_TARGET __attribute__((target("avx512f")))
constexpr std::size_t kOneVector = 1;
#include "solve/cholesky/front_kernel.inc"
#undef ABFLAT_LANES
#undef ABFLAT_TARGET
}  // namespace eight
#endif

bool factorBlock(Block& block, const Front& front, SimdWidth width) {
#ifdef __x86_64__
  if (width == SimdWidth::Eight) return eight::factorBlock(block, front);
  if (width == SimdWidth::Four) return four::factorBlock(block, front);
#else
  static_cast<void>(width);
#endif
  return two::factorBlock(block, front);
}

}  // namespace

SimdWidth widestSimd() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f")) return SimdWidth::Eight;
  if (__builtin_cpu_supports("avx2")) return SimdWidth::Four;
#endif
  return SimdWidth::Two;
}

std::size_t frontWorkspace(std::size_t rows) {
  return kBlock * (kBlock + 1 + kMaxStrip + rows + 2 * kSliver);
}

PivotFailure factorFront(const Front& f, SimdWidth width) {
  Block b{};
  b.stride = f.rows;
  b.allowNegative = f.allowNegative;
  b.diagonal = f.workspace;
  b.inverse = b.diagonal + kBlock * kBlock;
  b.strip = b.inverse + kBlock;
  b.slivers = b.strip + kBlock * kMaxStrip;
  for (; b.begin < f.columns; b.begin += b.columns) {
    b.columns = f.columns - b.begin < kBlock ? f.columns - b.begin : kBlock;
    b.at = f.panel + b.begin * (f.rows + 1);
    b.sign = f.sign + b.begin;
    b.leastPivot = f.leastPivot + b.begin;
    if (!factorBlock(b, f, width)) return b.failure;
  }
  return {f.columns, 0};
}

}  // namespace abflat
