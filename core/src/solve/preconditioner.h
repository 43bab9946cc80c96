#pragma once

namespace abflat {

/// An approximate inverse of a symmetric positive definite matrix, symmetric and positive definite
/// itself. The same r gives the same z.
class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  /// z ~ A^-1 r; both have one entry per row of A and may not overlap.
  virtual void apply(const double* r, double* z) const = 0;
};

}  // namespace abflat
