#include "solve/cholesky/front_kernel.h"

#include <cmath>

namespace abflat {
namespace {

constexpr std::size_t kSliver = 4;     ///< rows in a sliver
constexpr std::size_t kBlock = 128;    ///< columns that are eliminated together
constexpr std::size_t kMaxStrip = 32;  ///< rows in the longest strip

constexpr std::size_t roundUp(std::size_t rows) { return (rows + kSliver - 1) / kSliver * kSliver; }

/// The columns that are eliminated together.
template <typename Scalar>
struct Block {
  std::size_t begin, columns;  ///< in the front
  Scalar* at;                  ///< its square on the diagonal
  std::size_t stride;
  Scalar* sign;      ///< per column
  Scalar* inverse;   ///< per column: S / L
  Scalar* diagonal;  ///< slivers of L11
  Scalar* strip;     ///< the current one
  Scalar* slivers;   ///< of L21: of the rows in the panel, then of the others
  const Scalar* leastPivot;
  bool allowNegative;
  PivotFailure failure;
};

template <typename Scalar>
bool acceptPivot(Block<Scalar>& b, std::size_t column, Scalar pivot) {
  const Scalar size = std::abs(pivot);
  if (!(size > b.leastPivot[column]) || !std::isfinite(size) || (pivot < 0 && !b.allowNegative)) {
    b.failure = {b.begin + column, pivot};
    return false;
  }
  b.sign[column] = pivot < 0 ? Scalar{-1} : Scalar{1};
  b.inverse[column] = b.sign[column] / std::sqrt(size);
  return true;
}

// Browsers begin with quickly made code and replace it from the next call of a function on: what is
// called once a tile becomes fast soon, what loops over a whole front never.
#ifdef __wasm__
#define ABFLAT_TILE __attribute__((noinline))
#else
#define ABFLAT_TILE inline
#endif

#define ABFLAT_SCALAR double
#define ABFLAT_TARGET
namespace double2 {
#define ABFLAT_LANES 2
#include "solve/cholesky/front_kernel.inc"
#undef ABFLAT_LANES
}  // namespace double2
#undef ABFLAT_SCALAR
#define ABFLAT_SCALAR float
namespace float4 {
#define ABFLAT_LANES 4
#include "solve/cholesky/front_kernel.inc"
#undef ABFLAT_LANES
}  // namespace float4
#undef ABFLAT_TARGET
#undef ABFLAT_SCALAR

#ifdef __x86_64__
#define ABFLAT_TARGET __attribute__((target("avx2")))
#define ABFLAT_SCALAR double
namespace double4 {
#define ABFLAT_LANES 4
#include "solve/cholesky/front_kernel.inc"
#undef ABFLAT_LANES
}  // namespace double4
#undef ABFLAT_SCALAR
#define ABFLAT_SCALAR float
namespace float8 {
#define ABFLAT_LANES 8
#include "solve/cholesky/front_kernel.inc"
#undef ABFLAT_LANES
}  // namespace float8
#undef ABFLAT_TARGET
#undef ABFLAT_SCALAR

#define ABFLAT_TARGET __attribute__((target("avx512f")))
#define ABFLAT_SCALAR double
namespace double8 {
#define ABFLAT_LANES 8
#include "solve/cholesky/front_kernel.inc"
#undef ABFLAT_LANES
}  // namespace double8
#undef ABFLAT_SCALAR
#define ABFLAT_SCALAR float
namespace float16 {
#define ABFLAT_LANES 16
#include "solve/cholesky/front_kernel.inc"
#undef ABFLAT_LANES
}  // namespace float16
#undef ABFLAT_TARGET
#undef ABFLAT_SCALAR
#endif

bool factorBlock(Block<double>& block, const Front<double>& front, SimdWidth width) {
#ifdef __x86_64__
  if (width == SimdWidth::Eight) return double8::factorBlock(block, front);
  if (width == SimdWidth::Four) return double4::factorBlock(block, front);
#else
  static_cast<void>(width);
#endif
  return double2::factorBlock(block, front);
}

bool factorBlock(Block<float>& block, const Front<float>& front, SimdWidth width) {
#ifdef __x86_64__
  if (width == SimdWidth::Eight) return float16::factorBlock(block, front);
  if (width == SimdWidth::Four) return float8::factorBlock(block, front);
#else
  static_cast<void>(width);
#endif
  return float4::factorBlock(block, front);
}

}  // namespace

SimdWidth widestSimd() {
#if defined(__x86_64__) && !defined(ABFLAT_TWO_LANES)
  if (__builtin_cpu_supports("avx512f")) return SimdWidth::Eight;
  if (__builtin_cpu_supports("avx2")) return SimdWidth::Four;
#endif
  return SimdWidth::Two;
}

std::size_t frontWorkspace(std::size_t rows) {
  return kBlock * (kBlock + 1 + kMaxStrip + rows + 2 * kSliver);
}

template <typename Scalar>
PivotFailure factorFront(const Front<Scalar>& f, SimdWidth width) {
  Block<Scalar> b{};
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

template PivotFailure factorFront(const Front<float>& front, SimdWidth width);
template PivotFailure factorFront(const Front<double>& front, SimdWidth width);

}  // namespace abflat
