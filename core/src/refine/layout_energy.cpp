#include "refine/layout_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr std::size_t kTrianglesPerSum = 4096;  ///< triangles per piece of work

/// valueOf(triangles) for consecutive pieces of the triangles, in order.
template <class ValueOf>
std::vector<double> byPieces(const RestTriangles& rest, ThreadPool* pool, const ValueOf& valueOf) {
  std::vector<double> out((rest.size() + kTrianglesPerSum - 1) / kTrianglesPerSum);
  parallelFor(pool, out.size(), [&](std::size_t i) {
    out[i] = valueOf(IdRange{ChartTriangle(i * kTrianglesPerSum),
                             ChartTriangle(std::min(rest.size(), (i + 1) * kTrianglesPerSum))});
  });
  return out;
}

PlaneMap mapOf(const DiskChart& chart, const RestTriangles& rest, const std::vector<double>& uv,
               ChartTriangle f) {
  const auto [a, b, c] = pointsOf(uv, verticesOf(chart.vertexOfCorner, f));
  return rest[f].mapTo(a, b, c);
}

/// The smallest positive root of a + b x + c x^2 with a > 0, or infinity.
double firstRoot(double a, double b, double c) {
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return std::numeric_limits<double>::infinity();
  // 2a / (-b + root) is the root nearest to 0 on the side that b points to, without cancellation.
  const double denominator = -b + std::sqrt(discriminant);
  return denominator > 0 ? 2 * a / denominator : std::numeric_limits<double>::infinity();
}

}  // namespace

double layoutEnergy(const DiskChart& chart, const RestTriangles& rest, const Energy& energy,
                    const std::vector<double>& uv, ThreadPool* pool) {
  const auto energyOf = [&](IdRange<ChartTriangle> piece) {
    double sum = 0;
    for (const ChartTriangle f : piece) {
      if (rest[f].weight == 0) continue;
      const PlaneMap m = mapOf(chart, rest, uv, f);
      if (!(determinant(m) > 0)) return std::numeric_limits<double>::infinity();
      sum += rest[f].weight * elementEnergy(m, energy);
    }
    return sum;
  };
  double sum = 0;
  for (const double part : byPieces(rest, pool, energyOf)) sum += part;
  return sum;
}

double bestScale(const DiskChart& chart, const RestTriangles& rest, const Energy& energy,
                 const std::vector<double>& uv) {
  const double scale = energy.bestScale([&](const auto& use) {
    for (const ChartTriangle f : rest.ids())
      if (rest[f].weight != 0) use(rest[f].weight, mapOf(chart, rest, uv, f));
  });
  return scale > 0 && std::isfinite(scale) ? scale : 1;
}

double longestStep(const DiskChart& chart, const RestTriangles& rest, const std::vector<double>& uv,
                   const std::vector<double>& direction, double most, ThreadPool* pool) {
  const auto longestOf = [&](IdRange<ChartTriangle> piece) {
    double longest = most;
    for (const ChartTriangle f : piece) {
      if (rest[f].weight == 0) continue;
      const PlaneMap m = mapOf(chart, rest, uv, f), d = mapOf(chart, rest, direction, f);
      const double linear = 2 * (m[0] * d[0] + m[1] * d[1] - m[2] * d[2] - m[3] * d[3]);
      longest = std::min(longest, firstRoot(determinant(m), linear, determinant(d)));
    }
    return longest;
  };
  for (const double longest : byPieces(rest, pool, longestOf)) most = std::min(most, longest);
  return most;
}

}  // namespace abflat
