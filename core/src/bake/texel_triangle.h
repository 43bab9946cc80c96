#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/point2.h"

namespace abflat {

/// The corners of a triangle in the new image, in texels.
using TexelTriangle = std::array<Point2, 3>;

/// Its extent in x between two heights, which may be equal.
struct Span {
  double left, right;
};
std::optional<Span> spanBetween(const TexelTriangle& triangle, double top, double bottom);

/// Texels from `first` to before `last`.
struct TexelRange {
  std::int64_t first = 0, last = 0;

  bool isEmpty() const { return first >= last; }
};
/// Those of `count` that have their centres in [low, high], or any part.
TexelRange centresWithin(double low, double high, std::uint32_t count);
TexelRange touchedBy(double low, double high, std::uint32_t count);

/// Rows of an image of this height that a triangle touches.
TexelRange rowsOf(const TexelTriangle& triangle, std::uint32_t height);

/// Whether the centre of any texel of the image lies in it.
bool hasCentre(const TexelTriangle& triangle, std::uint32_t width, std::uint32_t height);

/// Weights of the corners at the points of a triangle.
class CornerWeights {
 public:
  using Weights = std::array<double, 3>;

  explicit CornerWeights(const TexelTriangle& triangle);

  /// Of the plane's point (x, y).
  Weights at(double x, double y) const {
    const double dx = x - first_[0], dy = y - first_[1];
    const double b = second_[0] * dx + second_[1] * dy, c = third_[0] * dx + third_[1] * dy;
    return {1 - b - c, b, c};
  }
  /// How those of the second and the third corner grow with x and y.
  const Point2& second() const { return second_; }
  const Point2& third() const { return third_; }

 private:
  Point2 first_, second_, third_;
};

/// Weights of the point of the outline that is nearest to (x, y).
CornerWeights::Weights nearestOnOutline(const TexelTriangle& triangle, double x, double y);

/// Whether a triangle is too thin for CornerWeights.
bool hasNoArea(const TexelTriangle& triangle);

}  // namespace abflat
