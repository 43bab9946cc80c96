#pragma once

/// Elementary functions composed of operations that IEEE 754 defines, so that they give the same
/// bits with every compiler, C library and machine. Errors are below 1.5 units in the last place
/// (atan2: below 2).
namespace abflat::portable {

/// Beyond 1e5 radians the argument is reduced using the double nearest to 2 pi.
double sin(double x);
double cos(double x);

/// Both, for little more than the price of one.
struct SinCos {
  double sin, cos;
};
SinCos sinCos(double x);

/// Natural logarithm.
double log(double x);
double exp(double x);

/// In [-pi, pi].
double atan2(double y, double x);

/// Without intermediate overflow or underflow.
double hypot(double x, double y);
double hypot(double x, double y, double z);

}  // namespace abflat::portable
