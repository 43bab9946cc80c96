#include "solve/cholesky/front_kernel.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "solve/cholesky/large_buffer.h"

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

// Browsers start with quickly compiled code and replace it at the next call of a function: a
// function called once per tile soon becomes fast, one that loops over a whole front never does.
#ifdef __wasm__
#define ABFLAT_TILE __attribute__((noinline))
#else
#define ABFLAT_TILE inline
#endif

/// What front_kernel.inc provides for one scalar type and vector width.
template <typename Scalar>
struct Kernel {
  bool (*factorDiagonal)(Block<Scalar>&);
  std::size_t (*stripCount)(const Block<Scalar>&, const Front<Scalar>&);
  void (*solveStrips)(const Block<Scalar>&, const Front<Scalar>&, std::size_t, std::size_t,
                      Scalar*);
  void (*updateStrips)(const Block<Scalar>&, const Front<Scalar>&, std::size_t, std::size_t,
                       const Scalar*);
  void (*eliminateStrips)(const Block<Scalar>&, const Front<Scalar>&);
};

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

template <typename Scalar>
const Kernel<Scalar>& kernelOf(SimdWidth width);

template <>
const Kernel<double>& kernelOf(SimdWidth width) {
#ifdef __x86_64__
  if (width == SimdWidth::Eight) return double8::kKernel;
  if (width == SimdWidth::Four) return double4::kKernel;
#else
  static_cast<void>(width);
#endif
  return double2::kKernel;
}

template <>
const Kernel<float>& kernelOf(SimdWidth width) {
#ifdef __x86_64__
  if (width == SimdWidth::Eight) return float16::kKernel;
  if (width == SimdWidth::Four) return float8::kKernel;
#else
  static_cast<void>(width);
#endif
  return float4::kKernel;
}

/// Works on the strips of a block in parallel: all of them are packed before any is used.
template <typename Scalar>
class ParallelStrips {
 public:
  ParallelStrips(const Front<Scalar>& front, const Kernel<Scalar>& kernel)
      : f_(front), kernel_(kernel) {}

  bool isWorthIt(const Block<Scalar>& b) const {
    const auto rest = static_cast<double>(f_.rows - b.begin - b.columns);
    const auto columns = static_cast<double>(b.columns);
    return isParallel(f_.pool) && rest * (rest / 2 + columns) * columns > kLargeBlock;
  }

  void eliminate(const Block<Scalar>& b) {
    if (!packed_) packed_ = largeBuffer<Scalar>(kBlock * (f_.rows + 4 * kMaxStrip));
    const std::size_t count = kernel_.stripCount(b, f_), pieces = (count + kPiece - 1) / kPiece;
    const auto end = [&](std::size_t i) { return std::min(count, (i + 1) * kPiece); };
    parallelFor(f_.pool, pieces, [&](std::size_t i) {
      kernel_.solveStrips(b, f_, i * kPiece, end(i), packed_.get());
    });
    // The last strips are the longest.
    parallelFor(f_.pool, pieces, [&](std::size_t k) {
      const std::size_t i = pieces - 1 - k;
      kernel_.updateStrips(b, f_, i * kPiece, end(i), packed_.get());
    });
  }

 private:
  /// Multiplications from which waking up other threads pays off: about 0.3 ms.
  static constexpr double kLargeBlock = 2e6;
  static constexpr std::size_t kPiece = 2;  ///< strips per piece of work

  const Front<Scalar>& f_;
  const Kernel<Scalar>& kernel_;
  LargeBuffer<Scalar> packed_;
};

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
  const Kernel<Scalar>& kernel = kernelOf<Scalar>(width);
  ParallelStrips<Scalar> strips(f, kernel);
  for (; b.begin < f.columns; b.begin += b.columns) {
    b.columns = f.columns - b.begin < kBlock ? f.columns - b.begin : kBlock;
    b.at = f.panel + b.begin * (f.rows + 1);
    b.sign = f.sign + b.begin;
    b.leastPivot = f.leastPivot + b.begin;
    if (!kernel.factorDiagonal(b)) return b.failure;
    if (strips.isWorthIt(b))
      strips.eliminate(b);
    else
      kernel.eliminateStrips(b, f);
    const std::size_t rest = f.rows - b.begin;
    if (f.pool) f.pool->beat(rest * rest * b.columns / kMultipliesPerStep);
  }
  return {f.columns, 0};
}

template PivotFailure factorFront(const Front<float>& front, SimdWidth width);
template PivotFailure factorFront(const Front<double>& front, SimdWidth width);

}  // namespace abflat
