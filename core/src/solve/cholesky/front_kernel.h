#pragma once

#include <cstddef>
#include <cstdint>

namespace abflat {

class ThreadPool;

/// One dense front, of which the first `columns` columns are eliminated: A = L S L^T with a lower
/// triangular L and a diagonal S of signs. Only lower triangles are read; what lies above them is
/// undefined afterwards.
struct Front {
  std::size_t rows = 0, columns = 0;
  double* panel = nullptr;             ///< rows x columns, by columns: the matrix, then L
  double* update = nullptr;            ///< square of rows - columns, gets -L21 S L21^T
  double* sign = nullptr;              ///< per column, 1 or -1: S
  const double* leastPivot = nullptr;  ///< per column: a pivot must be larger in magnitude
  bool allowNegative = true;
  double* workspace = nullptr;  ///< frontWorkspace(rows) doubles
  ThreadPool* pool = nullptr;   ///< for the parts of a large front; null: one thread
};

struct PivotFailure {
  std::size_t column;  ///< of the front; == Front::columns if there is none
  double value;
};

/// Widest vectors of a kernel. All kernels add the same products in the same order without fusing,
/// so their results are the same to the last bit.
enum class SimdWidth : std::uint8_t { Two = 2, Four = 4, Eight = 8 };

/// The widest that this machine can run.
SimdWidth widestSimd();

std::size_t frontWorkspace(std::size_t rows);

/// `width` must not be above widestSimd().
PivotFailure factorFront(const Front& front, SimdWidth width);

}  // namespace abflat
