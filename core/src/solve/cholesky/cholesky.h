#pragma once

#include <memory>

#include "base/parallel.h"
#include "solve/cholesky/front_kernel.h"
#include "solve/cholesky/large_buffer.h"
#include "solve/cholesky/symbolic.h"

namespace abflat {

struct CholeskyOptions {
  /// False: a negative pivot is a failure, as in a Cholesky factorisation proper.
  bool allowNegative = true;
  /// A pivot of at most this share of the diagonal entry in the matrix counts as 0.
  double pivotTolerance = 0;
  SimdWidth simd = widestSimd();  ///< results do not depend on it
  ThreadPool* pool = nullptr;     ///< results do not depend on it; null: one thread
};

struct CholeskyStatus {
  enum class Code : std::uint8_t { Ok, ZeroPivot, NegativePivot, NotFinite };
  Code code = Code::Ok;
  std::uint32_t column = 0;  ///< column of the matrix at which a pivot failed
  double pivot = 0;
  bool isOk() const { return code == Code::Ok; }
};

/// P A P^T = L S L^T of a symmetric matrix, L lower triangular and S a diagonal of signs: for
/// positive definite matrices, and for others whose pivots need no exchange. A factor of floats
/// takes half the memory and time, and is as good a preconditioner as the precision of floats
/// allows.
template <typename Scalar>
class BasicCholesky {
 public:
  explicit BasicCholesky(std::shared_ptr<const CholeskySymbolic> symbolic,
                         CholeskyOptions options = {})
      : symbolic_(std::move(symbolic)), options_(options) {}

  const CholeskySymbolic& symbolic() const { return *symbolic_; }

  /// `values` in the order of the pattern that was analysed.
  CholeskyStatus factorize(const double* values);

  /// Replaces the columns of b, each `size` long and stored one after another, by the solutions.
  /// Valid after a successful factorisation, until the next one.
  void solve(double* b, std::size_t columns = 1) const;

  std::uint32_t negativePivots() const { return negativePivots_; }

 private:
  class Factorization;

  void allocate();
  void assemble(std::uint32_t supernode, const double* values, ThreadPool* pool);
  CholeskyStatus failure(std::uint32_t supernode, const PivotFailure& failure) const;

  std::shared_ptr<const CholeskySymbolic> symbolic_;
  CholeskyOptions options_;
  LargeBuffer<Scalar> factor_;
  LargeBuffer<Scalar> sign_, leastPivot_;  ///< per column of the factor
  std::uint32_t negativePivots_ = 0;
};

using Cholesky = BasicCholesky<double>;
using FloatCholesky = BasicCholesky<float>;

}  // namespace abflat
