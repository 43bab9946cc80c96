#include "bake/texel_triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abflat {
namespace {

/// Height to length of a triangle that is no more than rounding.
constexpr double kThinnest = 1e-9;
/// The length, in texels, of one that is no more than a point.
constexpr double kShortest = 1e-6;

std::int64_t clampedTo(double value, std::uint32_t count) {
  return static_cast<std::int64_t>(std::clamp(value, 0.0, 1.0 * count));
}

double doubledArea(const TexelTriangle& p) {
  return (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
}

}  // namespace

std::optional<Span> spanBetween(const TexelTriangle& triangle, double top, double bottom) {
  Span out = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto include = [&](double x) {
    out.left = std::min(out.left, x);
    out.right = std::max(out.right, x);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    // In an order of their own, so that both triangles at an edge find the same.
    const auto& [a, b] = std::minmax(
        triangle[k], triangle[(k + 1) % 3],
        [](const Point2& p, const Point2& q) { return p[1] != q[1] ? p[1] < q[1] : p[0] < q[0]; });
    if (a[1] > bottom || b[1] < top) continue;
    const auto xAt = [&a = a, &b = b](double y) {
      if (y <= a[1]) return a[0];
      if (y >= b[1]) return b[0];
      const double x = a[0] + (y - a[1]) * ((b[0] - a[0]) / (b[1] - a[1]));
      return std::clamp(x, std::min(a[0], b[0]), std::max(a[0], b[0]));
    };
    include(xAt(top));
    if (top < bottom) include(xAt(bottom));
    if (a[1] == b[1]) include(b[0]);
  }
  if (out.left > out.right) return std::nullopt;
  return out;
}

TexelRange centresWithin(double low, double high, std::uint32_t count) {
  return {clampedTo(std::ceil(low - 0.5), count), clampedTo(std::floor(high - 0.5) + 1, count)};
}

TexelRange touchedBy(double low, double high, std::uint32_t count) {
  const double first = std::floor(low);
  return {clampedTo(first, count), clampedTo(std::max(std::ceil(high), first + 1), count)};
}

TexelRange rowsOf(const TexelTriangle& triangle, std::uint32_t height) {
  const auto [low, high] = std::minmax({triangle[0][1], triangle[1][1], triangle[2][1]});
  return touchedBy(low, high, height);
}

bool hasCentre(const TexelTriangle& triangle, std::uint32_t width, std::uint32_t height) {
  const TexelRange rows = rowsOf(triangle, height);
  for (std::int64_t y = rows.first; y < rows.last; ++y) {
    const double at = static_cast<double>(y) + 0.5;
    const std::optional<Span> span = spanBetween(triangle, at, at);
    if (span && !centresWithin(span->left, span->right, width).isEmpty()) return true;
  }
  return false;
}

CornerWeights::CornerWeights(const TexelTriangle& p) : first_(p[0]) {
  const double area = doubledArea(p);
  second_ = {(p[2][1] - p[0][1]) / area, (p[0][0] - p[2][0]) / area};
  third_ = {(p[0][1] - p[1][1]) / area, (p[1][0] - p[0][0]) / area};
}

CornerWeights::Weights nearestOnOutline(const TexelTriangle& triangle, double x, double y) {
  double least = std::numeric_limits<double>::infinity();
  CornerWeights::Weights out = {1, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 &a = triangle[k], &b = triangle[(k + 1) % 3];
    const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
    const double along = (x - a[0]) * dx + (y - a[1]) * dy;
    const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
    const double offX = a[0] + t * dx - x, offY = a[1] + t * dy - y;
    const double distance = offX * offX + offY * offY;
    if (distance >= least) continue;
    least = distance;
    out = {0, 0, 0};
    out[k] = 1 - t;
    out[(k + 1) % 3] = t;
  }
  return out;
}

bool hasNoArea(const TexelTriangle& p) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double dx = p[(k + 1) % 3][0] - p[k][0], dy = p[(k + 1) % 3][1] - p[k][1];
    longest = std::max(longest, dx * dx + dy * dy);
  }
  return !(longest > kShortest * kShortest && std::abs(doubledArea(p)) > kThinnest * longest);
}

}  // namespace abflat
