#include "refine/layout_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/point2.h"
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

/// How z and w change as vertices move: row 2k for vertex k in u, row 2k + 1 in v.
std::array<PlaneMap, 6> changesOf(const RestTriangle& t) {
  const Point2 c[3] = {{-t.c1x, -t.c1y - t.c2y}, {t.c1x, t.c1y}, {0, t.c2y}};
  std::array<PlaneMap, 6> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [x, y] = c[k];
    out[2 * k] = {x, -y, x, y};
    out[2 * k + 1] = {y, x, -y, x};
  }
  return out;
}

double innerProduct(const PlaneMap& a, const PlaneMap& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

PlaneMap product(const std::array<double, 10>& h, const PlaneMap& x) {
  return {h[0] * x[0] + h[1] * x[1] + h[3] * x[2] + h[6] * x[3],
          h[1] * x[0] + h[2] * x[1] + h[4] * x[2] + h[7] * x[3],
          h[3] * x[0] + h[4] * x[1] + h[5] * x[2] + h[8] * x[3],
          h[6] * x[0] + h[7] * x[1] + h[8] * x[2] + h[9] * x[3]};
}

/// `v`: the triangle's vertices.
TriangleRows rowsOf(const RestTriangle& rest, const TriangleVertices& v, const LayoutPoint& at) {
  TriangleRows out{};
  if (rest.weight == 0) return out;
  const auto p = pointsOf(at.uv, v);
  const ElementDerivatives d =
      elementDerivatives(rest.mapTo(p[0], p[1], p[2]), at.energy, at.curvature);
  const std::array<PlaneMap, 6> changes = changesOf(rest);
  std::array<PlaneMap, 6> products;
  for (std::size_t r = 0; r < 6; ++r) {
    out.rightHandSide[r] = rest.weight * innerProduct(d.gradient, changes[r]);
    products[r] = product(d.hessian, changes[r]);
    for (double& x : products[r]) x *= rest.weight;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    double *ofU = &out.matrix[k * (2 * k + 1)], *ofV = ofU + 2 * k + 1;
    for (std::size_t l = 0; l < k; ++l) {
      // Rounded alike whichever corner is the first.
      const bool isLater = v[l] < v[k];
      const PlaneMap* left = &(isLater ? changes : products)[2 * k];
      const PlaneMap* right = &(isLater ? products : changes)[2 * l];
      ofU[2 * l] = innerProduct(left[0], right[0]);
      ofU[2 * l + 1] = innerProduct(left[0], right[1]);
      ofV[2 * l] = innerProduct(left[1], right[0]);
      ofV[2 * l + 1] = innerProduct(left[1], right[1]);
    }
    ofU[2 * k] = innerProduct(changes[2 * k], products[2 * k]);
    ofV[2 * k] = innerProduct(changes[2 * k + 1], products[2 * k]);
    ofV[2 * k + 1] = innerProduct(changes[2 * k + 1], products[2 * k + 1]);
  }
  return out;
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

RowSystem layoutRows(const DiskChart& chart, ThreadPool* pool) {
  std::vector<std::uint32_t> firstRow(chart.vertexCount() + 1);
  for (std::uint32_t v = 0; v < firstRow.size(); ++v) firstRow[v] = 2 * v;
  return RowSystem(chart.vertexOfCorner, std::move(firstRow), pool);
}

void assembleDerivatives(const DiskChart& chart, const RestTriangles& rest, const LayoutPoint& at,
                         const IdVector<ChartVertex, std::uint8_t>& isFixed, RowSystem& out) {
  out.rightHandSide.setZero();
  out.assemble(isFixed, [&](ChartTriangle f) {
    return rowsOf(rest[f], verticesOf(chart.vertexOfCorner, f), at);
  });
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
