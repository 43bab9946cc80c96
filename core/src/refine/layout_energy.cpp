#include "refine/layout_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abflat {
namespace {

constexpr std::size_t kGrain = 4096;  ///< triangles that are one piece of work

/// valueOf(begin, end) of pieces of the triangles, in order.
template <class ValueOf>
std::vector<double> byPieces(std::size_t triangles, ThreadPool* pool, const ValueOf& valueOf) {
  std::vector<double> out((triangles + kGrain - 1) / kGrain);
  parallelFor(pool, out.size(), [&](std::size_t i) {
    out[i] = valueOf(i * kGrain, std::min(triangles, (i + 1) * kGrain));
  });
  return out;
}

const double* at(const std::vector<double>& uv, std::uint32_t vertex) {
  return &uv[2 * std::size_t{vertex}];
}

PlaneMap mapOf(const DiskChart& chart, const std::vector<RestTriangle>& rest,
               const std::vector<double>& uv, std::size_t f) {
  const std::uint32_t* v = &chart.vertexOfCorner[3 * f];
  return rest[f].mapTo(at(uv, v[0]), at(uv, v[1]), at(uv, v[2]));
}

double determinant(const PlaneMap& m) {
  return m[0] * m[0] + m[1] * m[1] - m[2] * m[2] - m[3] * m[3];
}

/// The least positive root of a + b x + c x^2 with a > 0, or infinity.
double firstRoot(double a, double b, double c) {
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return std::numeric_limits<double>::infinity();
  // 2a / (-b + root) is the root nearest to 0 on the side that b points to, without cancellation.
  const double denominator = -b + std::sqrt(discriminant);
  return denominator > 0 ? 2 * a / denominator : std::numeric_limits<double>::infinity();
}

}  // namespace

double layoutEnergy(const DiskChart& chart, const std::vector<RestTriangle>& rest, double balance,
                    const std::vector<double>& uv, ThreadPool* pool) {
  const auto energyOf = [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t f = begin; f < end; ++f) {
      if (rest[f].weight == 0) continue;
      const PlaneMap m = mapOf(chart, rest, uv, f);
      if (!(determinant(m) > 0)) return std::numeric_limits<double>::infinity();
      sum += rest[f].weight * elementEnergy(m, balance);
    }
    return sum;
  };
  double sum = 0;
  for (const double part : byPieces(rest.size(), pool, energyOf)) sum += part;
  return sum;
}

double bestScale(const DiskChart& chart, const std::vector<RestTriangle>& rest, double balance,
                 const std::vector<double>& uv) {
  if (balance == 0) return 1;
  double growing = 0, shrinking = 0;
  for (std::size_t f = 0; f < rest.size(); ++f) {
    if (rest[f].weight == 0) continue;
    const PlaneMap m = mapOf(chart, rest, uv, f);
    const double square = m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + m[3] * m[3];
    growing += rest[f].weight * square;
    shrinking += rest[f].weight * square / (determinant(m) * determinant(m));
  }
  const double scale = std::sqrt(std::sqrt(shrinking / growing));
  return scale > 0 && std::isfinite(scale) ? scale : 1;
}

double longestStep(const DiskChart& chart, const std::vector<RestTriangle>& rest,
                   const std::vector<double>& uv, const std::vector<double>& direction, double most,
                   ThreadPool* pool) {
  const auto longestOf = [&](std::size_t begin, std::size_t end) {
    double longest = most;
    for (std::size_t f = begin; f < end; ++f) {
      if (rest[f].weight == 0) continue;
      const PlaneMap m = mapOf(chart, rest, uv, f), d = mapOf(chart, rest, direction, f);
      const double linear = 2 * (m[0] * d[0] + m[1] * d[1] - m[2] * d[2] - m[3] * d[3]);
      longest = std::min(longest, firstRoot(determinant(m), linear, determinant(d)));
    }
    return longest;
  };
  for (const double longest : byPieces(rest.size(), pool, longestOf))
    most = std::min(most, longest);
  return most;
}

}  // namespace abflat
