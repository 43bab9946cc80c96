#pragma once

#include <algorithm>
#include <cmath>

#include "research/linear_solve.h"

namespace abflat {

/// Lanczos' process in the inner product of a preconditioner: A V = M V T with T tridiagonal.
class Lanczos {
 public:
  Lanczos(const LinearOperator& matrix, const LinearOperator& preconditioner,
          const Eigen::VectorXd& rhs)
      : matrix_(matrix), preconditioner_(preconditioner), older_(rhs), newer_(rhs), y_(rhs) {
    beta_ = norm();
  }

  double alpha() const { return alpha_; }
  double beta() const { return beta_; }  ///< of the next vector
  double previousBeta() const { return previousBeta_; }
  const Eigen::VectorXd& vector() const { return v_; }

  /// Takes the next vector; beta() must not be 0.
  void advance() {
    v_ = y_ / beta_;
    matrix_(v_, y_);
    if (previousBeta_ > 0) y_ -= (beta_ / previousBeta_) * older_;
    alpha_ = v_.dot(y_);
    y_ -= (alpha_ / beta_) * newer_;
    older_.swap(newer_);
    newer_ = y_;
    previousBeta_ = beta_;
    beta_ = norm();
  }

 private:
  double norm() {
    if (preconditioner_) preconditioner_(newer_, y_);
    return std::sqrt(std::max(0.0, newer_.dot(y_)));
  }

  const LinearOperator& matrix_;
  const LinearOperator& preconditioner_;
  Eigen::VectorXd older_, newer_, y_, v_;
  double alpha_ = 0, beta_ = 0, previousBeta_ = 0;
};

}  // namespace abflat
