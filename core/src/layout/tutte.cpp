#include "layout/tutte.h"

#include <Eigen/SparseCholesky>
#include <cmath>

#include "angle/constants.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Boundary vertices on a circle of the chart's area; a shortest arc keeps them apart.
void placeBoundary(const DiskChart& chart, std::vector<double>& uv) {
  std::vector<double> length;
  double total = 0;
  for (const std::uint32_t h : chart.boundary) {
    length.push_back(norm(
        edgeVector(chart.positions, chart.vertexOfCorner[h], chart.vertexOfCorner[nextCorner(h)])));
    total += length.back();
  }
  constexpr double kShortestArc = 0.1;  // of the mean
  const double least = kShortestArc * total / static_cast<double>(length.size());
  total = 0;
  for (double& l : length) total += l = std::max(l, least);
  const double radius = std::sqrt(surfaceArea(chart) / kPi);
  double passed = 0;
  for (std::size_t i = 0; i < length.size(); ++i) {
    const std::uint32_t v = chart.vertexOfCorner[chart.boundary[i]];
    uv[2 * v] = radius * (1 + std::cos(2 * kPi * passed / total));
    uv[2 * v + 1] = radius * (1 + std::sin(2 * kPi * passed / total));
    passed += length[i];
  }
}

}  // namespace

std::vector<double> tutteEmbedding(const DiskChart& chart) {
  std::vector<double> uv(2 * static_cast<std::size_t>(chart.vertexCount()), 0);
  placeBoundary(chart, uv);
  std::vector<int> unknown(chart.vertexCount(), 0);
  for (const std::uint32_t h : chart.boundary) unknown[chart.vertexOfCorner[h]] = -1;
  int n = 0;
  for (int& u : unknown)
    if (u == 0) u = n++;
  if (n == 0) return uv;

  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(n, 2);
  for (std::uint32_t h = 0; h < chart.twin.size(); ++h) {
    // Every interior vertex begins one half-edge to each neighbour.
    const std::uint32_t a = chart.vertexOfCorner[h], b = chart.vertexOfCorner[nextCorner(h)];
    if (unknown[a] < 0) continue;
    entries.emplace_back(unknown[a], unknown[a], 1);
    if (unknown[b] >= 0)
      entries.emplace_back(unknown[a], unknown[b], -1);
    else
      for (Eigen::Index d = 0; d < 2; ++d)
        rhs(unknown[a], d) += uv[2 * b + static_cast<std::size_t>(d)];
  }
  Eigen::SparseMatrix<double> laplacian(n, n);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(laplacian);
  const Eigen::MatrixXd solved = factor.solve(rhs);
  for (std::uint32_t v = 0; v < chart.vertexCount(); ++v)
    if (unknown[v] >= 0)
      for (std::size_t d = 0; d < 2; ++d)
        uv[2 * v + d] = solved(unknown[v], static_cast<Eigen::Index>(d));
  return uv;
}

}  // namespace abflat
