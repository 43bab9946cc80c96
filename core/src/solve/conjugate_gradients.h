#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <limits>

#include "solve/preconditioner.h"

namespace abflat {

struct ConjugateGradientsOptions {
  double tolerance = 1e-12;  ///< of the residual's largest entry
  int maxIterations = 1000;
  /// Gives up once the speed so far suggests this many further iterations.
  double worthwhile = std::numeric_limits<double>::infinity();
};

struct ConjugateGradientsResult {
  /// NotPositive: a direction p with p' A p <= 0 or a residual r with r' M r <= 0 was met.
  enum class Code : std::uint8_t { Converged, TooManyIterations, TooSlow, NotPositive };
  Code code = Code::Converged;
  int iterations = 0;
  double residual = 0;  ///< largest entry of |b - A x|
  bool isConverged() const { return code == Code::Converged; }
};

/// Preconditioned conjugate gradients (Hestenes and Stiefel), starting from x. `lower` is the lower
/// triangle of the symmetric matrix.
ConjugateGradientsResult conjugateGradients(const Eigen::SparseMatrix<double>& lower,
                                            const Eigen::VectorXd& b,
                                            const Preconditioner& preconditioner,
                                            Eigen::VectorXd& x,
                                            const ConjugateGradientsOptions& options = {});

}  // namespace abflat
