#include "solve/cholesky/front_kernel.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "parallel.h"

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

/// What front_kernel.inc provides for one vector width.
struct Kernel {
  bool (*factorDiagonal)(Block&);
  std::size_t (*stripCount)(const Block&, const Front&);
  void (*solveStrips)(const Block&, const Front&, std::size_t, std::size_t, double*);
  void (*updateStrips)(const Block&, const Front&, std::size_t, std::size_t, const double*);
  void (*eliminateStrips)(const Block&, const Front&);
};

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

const Kernel& kernelOf(SimdWidth width) {
#ifdef __x86_64__
  if (width == SimdWidth::Eight) return eight::kKernel;
  if (width == SimdWidth::Four) return four::kKernel;
#else
  static_cast<void>(width);
#endif
  return two::kKernel;
}

/// The strips of a block at the same time: all of them are packed before any is used.
class ParallelStrips {
 public:
  ParallelStrips(const Front& front, const Kernel& kernel) : f_(front), kernel_(kernel) {}

  bool isWorthIt(const Block& b) const {
    const auto rest = static_cast<double>(f_.rows - b.begin - b.columns);
    const auto columns = static_cast<double>(b.columns);
    return isParallel(f_.pool) && rest * (rest / 2 + columns) * columns > kLargeBlock;
  }

  void eliminate(const Block& b) {
    if (!packed_) packed_.reset(new double[kBlock * (f_.rows + 4 * kMaxStrip)]);
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
  /// Multiplications from which it pays to wake up other threads: about 0.3 ms.
  static constexpr double kLargeBlock = 2e6;
  static constexpr std::size_t kPiece = 2;  ///< strips in a piece of work

  const Front& f_;
  const Kernel& kernel_;
  std::unique_ptr<double[]> packed_;
};

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
  const Kernel& kernel = kernelOf(width);
  ParallelStrips strips(f, kernel);
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
  }
  return {f.columns, 0};
}

}  // namespace abflat
