#pragma once

#include <array>

namespace abflat {

/// What one triangle contributes to the Newton system, given its angles x and the multipliers of
/// its vertices. Local rows: 2k = angle sum of vertex k, 2k+1 = wheel of vertex k.
struct Element {
  std::array<double, 3> cot;       ///< cotangents of the angles: the wheels' derivatives
  std::array<double, 3> hessian;   ///< h: diagonal of the Hessian of the Lagrangian
  std::array<double, 3> gradient;  ///< 2 w (x - a)
  double triangleResidual;         ///< x0 + x1 + x2 - pi
  double determinant;  ///< h0 h1 + h1 h2 + h2 h0, > 0: of the Hessian on steps that sum to 0
};

/// B^T y: the derivative of y-weighted vertex constraints with respect to the three angles.
inline std::array<double, 3> applyTransposedJacobian(const Element& e,
                                                     const std::array<double, 6>& y) {
  std::array<double, 3> z;
  for (unsigned k = 0; k < 3; ++k) {
    // Corner k is "next" in the wheel of the vertex before it and "prev" in that of the vertex
    // after it.
    const double wheel = y[2 * ((k + 2) % 3) + 1] - y[2 * ((k + 1) % 3) + 1];
    z[k] = y[2 * k] + e.cot[k] * wheel;
  }
  return z;
}

/// B z: the change of the six vertex constraints for a change z of the three angles.
inline std::array<double, 6> applyJacobian(const Element& e, const std::array<double, 3>& z) {
  std::array<double, 6> y;
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned n = (k + 1) % 3, p = (k + 2) % 3;
    y[2 * k] = z[k];
    y[2 * k + 1] = e.cot[n] * z[n] - e.cot[p] * z[p];
  }
  return y;
}

/// P z: minus the angle step that minimises 1/2 d^T H d + z^T d among those that sum to 0. With D =
/// H^-1 this is D z - D 1 (1^T D z) / (1^T D 1), written so that one h may be 0 or negative.
inline std::array<double, 3> applyProjected(const Element& e, const std::array<double, 3>& z) {
  std::array<double, 3> out;
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned n = (k + 1) % 3, p = (k + 2) % 3;
    out[k] = (e.hessian[n] * (z[k] - z[p]) + e.hessian[p] * (z[k] - z[n])) / e.determinant;
  }
  return out;
}

/// D 1 / (1^T D 1): the cheapest angle step that sums to 1.
inline std::array<double, 3> unitStep(const Element& e) {
  std::array<double, 3> out;
  for (unsigned k = 0; k < 3; ++k)
    out[k] = e.hessian[(k + 1) % 3] * e.hessian[(k + 2) % 3] / e.determinant;
  return out;
}

/// B P B^T, symmetric positive semidefinite, row-major lower triangle (21 entries).
std::array<double, 21> elementMatrix(const Element& e);

}  // namespace abflat
