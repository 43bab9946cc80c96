#pragma once

#include <cstddef>
#include <cstdint>

namespace abflat {

class ThreadPool;

/// One dense front, of which the first `columns` columns are eliminated: A = L S L^T with a lower
/// triangular L and a diagonal S of signs. Only lower triangles are read; what lies above them is
/// undefined afterwards. `Scalar` is float or double.
template <typename Scalar>
struct Front {
  std::size_t rows = 0, columns = 0;
  Scalar* panel = nullptr;             ///< rows x columns, by columns: the matrix, then L
  Scalar* update = nullptr;            ///< square of rows - columns, gets -L21 S L21^T
  Scalar* sign = nullptr;              ///< per column, 1 or -1: S
  const Scalar* leastPivot = nullptr;  ///< per column: a pivot must be larger in magnitude
  bool allowNegative = true;
  Scalar* workspace = nullptr;  ///< frontWorkspace(rows) scalars
  ThreadPool* pool = nullptr;   ///< for the parts of a large front; null: one thread
};

/// Multiplications within a front that count as one small step of a Listener.
constexpr std::size_t kMultipliesPerStep = 4096;

struct PivotFailure {
  std::size_t column;  ///< of the front; == Front::columns if there is none
  double value;
};

/// Widest vectors of a kernel, in doubles; twice as many floats. All kernels add the same products
/// in the same order without fusing, so their results are the same to the last bit.
enum class SimdWidth : std::uint8_t { Two = 2, Four = 4, Eight = 8 };

/// The widest that this machine can run.
SimdWidth widestSimd();

std::size_t frontWorkspace(std::size_t rows);

/// `width` must not be above widestSimd().
template <typename Scalar>
PivotFailure factorFront(const Front<Scalar>& front, SimdWidth width);

}  // namespace abflat
