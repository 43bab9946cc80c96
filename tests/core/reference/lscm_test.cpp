#include "reference/lscm.h"

#include <Eigen/Core>
#include <cmath>
#include <set>

#include "catch.h"
#include "check/distortion.h"
#include "check/validity.h"
#include "mesh/triangle_geometry.h"
#include "pin/conformal_energy.h"
#include "reference/corner_angles.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Squared deviation of each triangle's map from a similarity, weighted by area: in the triangle's
/// own plane the map is (a c; b d), and a similarity has a = d, b = -c.
double deviation(const DiskChart& chart, const Eigen::VectorXd& x) {
  const std::size_t n = chart.vertexCount();
  const auto at = [&](std::size_t i) { return x[static_cast<Eigen::Index>(i)]; };
  double sum = 0;
  for (const ChartTriangle f : chart.triangles()) {
    const TriangleVertices v = verticesOf(chart.vertexOfCorner, f);
    const Vec3 p = edgeVector(chart.positions, v[0], v[1]),
               q = edgeVector(chart.positions, v[0], v[2]);
    const double x1 = norm(p), x2 = dot(p, q) / x1, y2 = norm(cross(p, q)) / x1;
    const double a = (at(v[1]) - at(v[0])) / x1, b = (at(n + v[1]) - at(n + v[0])) / x1;
    const double c = (at(v[2]) - at(v[0]) - a * x2) / y2;
    const double d = (at(n + v[2]) - at(n + v[0]) - b * x2) / y2;
    sum += x1 * y2 / 2 * ((a - d) * (a - d) + (b + c) * (b + c));
  }
  return sum;
}

Eigen::VectorXd stacked(const std::vector<double>& uv) {
  const Eigen::Map<const Eigen::Matrix2Xd> pairs(uv.data(), 2,
                                                 static_cast<Eigen::Index>(uv.size() / 2));
  Eigen::VectorXd out(pairs.size());
  out << pairs.row(0).transpose(), pairs.row(1).transpose();
  return out;
}

Eigen::VectorXd finiteDifferences(const DiskChart& chart, Eigen::VectorXd x) {
  constexpr double kStep = 1e-4;
  Eigen::VectorXd out(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double kept = x[i];
    x[i] = kept + kStep;
    const double above = deviation(chart, x);
    x[i] = kept - kStep;
    out[i] = (above - deviation(chart, x)) / (2 * kStep);
    x[i] = kept;
  }
  return out;
}

}  // namespace

TEST_CASE("the conformal energy and its gradient are those of the triangles' maps") {
  const DiskChart chart = chartOf(bumpyGrid(6, 5, 0.6, 1));
  const Eigen::SparseMatrix<double> energy = conformalEnergy(
      {chart.vertexOfCorner, chart.boundary}, chart.vertexCount(), drawableAngles(chart).raw());
  std::mt19937 random(1);
  std::normal_distribution<double> gauss;
  for (int repeat = 0; repeat < 5; ++repeat) {
    Eigen::VectorXd x(energy.rows());
    for (double& value : x) value = gauss(random);
    CHECK(x.dot(energy * x) == Approx(deviation(chart, x)));
    const Eigen::VectorXd gradient = 2 * (energy * x);
    CHECK((gradient - finiteDifferences(chart, x)).norm() < 1e-7 * gradient.norm());
  }
}

TEST_CASE("LSCM is a minimum: only the pins could lower the energy") {
  const DiskChart chart = chartOf(bumpyGrid(6, 5, 0.6, 2));
  const Embedding lscm = embedLscm(chart);
  REQUIRE(lscm.problem.empty());
  const Eigen::VectorXd x = stacked(lscm.uv);
  const Eigen::VectorXd gradient = finiteDifferences(chart, x);
  const auto [left, right] = findPins(chart);
  const std::size_t n = chart.vertexCount();
  const std::set<std::size_t> pinned{left, right, n + left, n + right};
  for (std::size_t i = 0; i < 2 * n; ++i)
    if (pinned.count(i) == 0) CHECK(std::abs(gradient[static_cast<Eigen::Index>(i)]) < 1e-8);
  CHECK(deviation(chart, x) > 1e-6);  // otherwise everything would be a minimum
  CHECK(x[left] == 0);
  CHECK(x[right] == 1);
}

TEST_CASE("LSCM reproduces a planar mesh up to a similarity") {
  const DiskChart chart = chartOf(transformed(bumpyGrid(20, 12, 0, 3), 250, {1, 2, 3}));
  const Embedding lscm = embedLscm(chart);
  REQUIRE(lscm.problem.empty());
  CHECK(checkValidity(chart, lscm.uv).valid());
  const Distortion d = measureDistortion(chart, lscm.uv);
  CHECK(d.angular < 1e-18);
  CHECK(d.length < 1e-18);
  CHECK(d.areaLog < 1e-9);
}

TEST_CASE("the pins are far apart, on the boundary, and the same under other numbers") {
  const PolygonMesh mesh = bumpyGrid(14, 4, 0.3, 4);
  const DiskChart chart = chartOf(mesh);
  const auto [a, b] = findPins(chart);
  const auto span = [&](std::uint32_t v, std::uint32_t w) {
    return norm(edgeVector(chart.positions, v, w));
  };
  double farthest = 0;
  std::set<std::uint32_t> boundary;
  for (const ChartCorner h : chart.boundary) {
    boundary.insert(chart.vertexOfCorner[h]);
    farthest = std::max(farthest, span(a, chart.vertexOfCorner[h]));
  }
  CHECK(boundary.count(a) + boundary.count(b) == 2);
  CHECK(span(a, b) == farthest);
  CHECK(span(a, b) * chart.unit > 13);
  const Renumbered other = renumbered(mesh, 5);
  const DiskChart changed = chartOf(other.mesh);
  const auto [c, d] = findPins(changed);
  CHECK(changed.inputVertex[c] == other.vertex[chart.inputVertex[a]]);
  CHECK(changed.inputVertex[d] == other.vertex[chart.inputVertex[b]]);
}

TEST_CASE("LSCM of triangles of zero area is finite, of a point a problem") {
  PolygonMesh mesh = bumpyGrid(5, 5, 0.3, 5);
  for (std::size_t d = 0; d < 3; ++d) mesh.positions[3 * 7 + d] = mesh.positions[3 * 8 + d];
  const Embedding lscm = embedLscm(chartOf(mesh));
  CHECK(lscm.problem.empty());
  for (const double x : lscm.uv) CHECK(std::isfinite(x));
  for (double& x : mesh.positions) x = 1;
  CHECK_FALSE(embedLscm(chartOf(mesh)).problem.empty());
}
