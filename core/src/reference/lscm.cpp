#include "reference/lscm.h"

#include <algorithm>
#include <tuple>

#include "mesh/triangle_geometry.h"
#include "reference/corner_angles.h"
#include "solve/symmetric_solve.h"
#include "sparse_assembly.h"

namespace abflat {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

double squaredDistance(const DiskChart& chart, std::uint32_t v, const Vec3& p) {
  double sum = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    const double x = chart.positions[3 * v + d] - p[d];
    sum += x * x;
  }
  return sum;
}

std::uint32_t farthestFrom(const DiskChart& chart, const Vec3& p) {
  std::uint32_t best = chart.vertexOfCorner[chart.boundary.front()];
  for (const std::uint32_t h : chart.boundary) {
    const std::uint32_t v = chart.vertexOfCorner[h];
    if (squaredDistance(chart, v, p) > squaredDistance(chart, best, p)) best = v;
  }
  return best;
}

Vec3 positionOf(const DiskChart& chart, std::uint32_t v) {
  return {chart.positions[3 * v], chart.positions[3 * v + 1], chart.positions[3 * v + 2]};
}

/// The rows of the unknowns that are not pinned; what the pins add comes to the right-hand side.
struct Reduced {
  Matrix matrix;
  Eigen::VectorXd rhs;
};

Reduced withoutPins(const Matrix& energy, const std::vector<int>& unknown,
                    const Eigen::VectorXd& pinned) {
  const int n = 1 + *std::max_element(unknown.begin(), unknown.end());
  Reduced out{{}, Eigen::VectorXd::Zero(n)};
  SparseEntries entries;
  entries.reserve(static_cast<std::size_t>(energy.nonZeros()));
  for (Eigen::Index c = 0; c < energy.outerSize(); ++c)
    for (Matrix::InnerIterator e(energy, c); e; ++e) {
      const int row = unknown[static_cast<std::size_t>(e.row())];
      const int column = unknown[static_cast<std::size_t>(c)];
      if (row < 0) continue;
      if (column >= 0)
        entries.emplace_back(row, column, e.value());
      else
        out.rhs[row] -= e.value() * pinned[c];
    }
  out.matrix = assembled(n, entries);
  return out;
}

}  // namespace

Matrix conformalEnergy(const DiskChart& chart) {
  const auto n = static_cast<int>(chart.vertexCount());
  SparseEntries entries;
  for (std::uint32_t f = 0; f < chart.triangleCount(); ++f) {
    const std::array<double, 3> angle = anglesOrMadeUp(chart.angles[f]);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto a = static_cast<int>(chart.vertexOfCorner[3 * f + k]);
      const auto b = static_cast<int>(chart.vertexOfCorner[3 * f + (k + 1) % 3]);
      const double w = cotangent(angle[(k + 2) % 3]) / 2;
      for (const int offset : {0, n}) {
        entries.emplace_back(a + offset, a + offset, w);
        entries.emplace_back(b + offset, b + offset, w);
        entries.emplace_back(a + offset, b + offset, -w);
        entries.emplace_back(b + offset, a + offset, -w);
      }
    }
  }
  // Twice the area, sum of u_a v_b - u_b v_a over the boundary, as a symmetric matrix.
  for (const std::uint32_t h : chart.boundary) {
    const auto a = static_cast<int>(chart.vertexOfCorner[h]);
    const auto b = static_cast<int>(chart.vertexOfCorner[nextCorner(h)]);
    for (const auto& [row, column, value] :
         {std::tuple{a, b + n, -0.5}, std::tuple{b, a + n, 0.5}}) {
      entries.emplace_back(row, column, value);
      entries.emplace_back(column, row, value);
    }
  }
  return assembled(2 * Eigen::Index{n}, entries);
}

std::array<std::uint32_t, 2> findPins(const DiskChart& chart) {
  Vec3 middle{0, 0, 0};
  for (const std::uint32_t h : chart.boundary)
    for (std::size_t d = 0; d < 3; ++d)
      middle[d] += chart.positions[3 * chart.vertexOfCorner[h] + d] /
                   static_cast<double>(chart.boundary.size());
  const std::uint32_t first = farthestFrom(chart, middle);
  return {first, farthestFrom(chart, positionOf(chart, first))};
}

Embedding embedLscm(const DiskChart& chart) {
  const std::size_t n = chart.vertexCount();
  Embedding out{std::vector<double>(2 * n, 0), {}};
  const auto [left, right] = findPins(chart);
  if (left == right) {
    out.problem = "all boundary vertices are at the same place: there is nothing to pin";
    return out;
  }
  std::vector<int> unknown(2 * n, 0);
  for (const std::uint32_t pin : {left, right}) unknown[pin] = unknown[n + pin] = -1;
  int count = 0;
  for (int& u : unknown)
    if (u == 0) u = count++;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * n));
  x[right] = 1;
  const Reduced system = withoutPins(conformalEnergy(chart), unknown, x);
  const Eigen::MatrixXd solved = solveSymmetric(system.matrix, system.rhs);
  if (solved.size() == 0 || !solved.allFinite()) {
    out.problem =
        "the linear system of the conformal energy cannot be solved: it is singular to "
        "the precision of numbers";
    return out;
  }
  for (std::size_t i = 0; i < 2 * n; ++i)
    if (unknown[i] >= 0) x[static_cast<Eigen::Index>(i)] = solved(unknown[i]);
  for (std::size_t v = 0; v < n; ++v) {
    out.uv[2 * v] = x[static_cast<Eigen::Index>(v)];
    out.uv[2 * v + 1] = x[static_cast<Eigen::Index>(n + v)];
  }
  return out;
}

}  // namespace abflat
