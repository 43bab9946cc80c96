#pragma once

#include <array>
#include <cstddef>

namespace abflat {

/// Red, green, blue and alpha, or a vector, on which processors work at once.
struct Colour {
  // NOLINTNEXTLINE(modernize-use-using): the attribute needs a typedef
  typedef float Vector __attribute__((vector_size(16)));

  Colour() : v{0, 0, 0, 0} {}
  explicit Colour(Vector values) : v(values) {}
  Colour(float red, float green, float blue, float alpha) : v{red, green, blue, alpha} {}
  explicit Colour(const std::array<double, 4>& values) {
    for (std::size_t d = 0; d < 4; ++d) v[d] = static_cast<float>(values[d]);
  }

  Vector v;
};

inline Colour operator+(Colour a, Colour b) { return Colour(a.v + b.v); }
inline Colour operator*(Colour a, Colour b) { return Colour(a.v * b.v); }
inline Colour operator*(Colour a, float b) { return Colour(a.v * b); }

/// The weight of a transparent colour: next to nothing, but enough that colours exist where all are
/// transparent.
constexpr float kLeastOpacity = 1e-6f;

/// The colour that colours add up to which were multiplied by their opacity, with shares whose sum
/// is 1.
inline Colour settled(Colour sum) {
  const float weight = sum.v[3];
  sum = sum * (1 / weight);
  sum.v[3] = weight > kLeastOpacity ? weight - kLeastOpacity : 0;
  return sum;
}

}  // namespace abflat
