#include "reference/edge_weights.h"

#include <cmath>

#include "abflat/samples.h"
#include "base/constants.h"
#include "catch.h"
#include "check/validity.h"
#include "layout/tutte.h"
#include "mesh/triangle_geometry.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

std::vector<bool> interiorOf(const DiskChart& chart) {
  std::vector<bool> out(chart.vertexCount(), true);
  for (const ChartCorner h : chart.boundary) out[chart.vertexOfCorner[h]] = false;
  return out;
}

Embedding onCircle(const DiskChart& chart, const HalfEdgeWeights& weights) {
  return embedByWeights(chart, weights, boundaryOnCircle(chart));
}

/// Area times the squared gradients of both coordinates, from triangles in their own planes.
double dirichlet(const DiskChart& chart, const std::vector<double>& uv) {
  double sum = 0;
  for (const ChartTriangle f : chart.triangles()) {
    const TriangleVertices v = verticesOf(chart.vertexOfCorner, f);
    const Vec3 p = edgeVector(chart.positions, v[0], v[1]),
               q = edgeVector(chart.positions, v[0], v[2]);
    const double x1 = norm(p), x2 = dot(p, q) / x1, y2 = norm(cross(p, q)) / x1;
    for (std::size_t d = 0; d < 2; ++d) {
      const double first = uv[2 * v[1] + d] - uv[2 * v[0] + d];
      const double second = uv[2 * v[2] + d] - uv[2 * v[0] + d];
      const double gx = first / x1, gy = (second - gx * x2) / y2;
      sum += x1 * y2 / 2 * (gx * gx + gy * gy);
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("mean value and harmonic weights have linear precision") {
  const PolygonMesh flat = bumpyGrid(9, 7, 0, 1);
  const DiskChart chart = chartOf(flat), turned = chartOf(transformed(flat, 3e-5, {1, 2, 3}));
  const std::vector<bool> isInterior = interiorOf(chart);
  std::vector<double> wanted, fixed;
  for (const ChartVertex v : chart.vertices())
    for (std::size_t d = 0; d < 2; ++d) {
      wanted.push_back(chart.positions[3 * v + d]);
      fixed.push_back(isInterior[v] ? 0 : wanted.back());
    }
  for (const HalfEdgeWeights& weights : {meanValueWeights(turned), harmonicWeights(turned)}) {
    const Embedding got = embedByWeights(chart, weights, fixed);
    REQUIRE(got.problem.empty());
    for (std::size_t i = 0; i < wanted.size(); ++i)
      CHECK(got.uv[i] == Approx(wanted[i]).margin(1e-9));
  }
}

TEST_CASE("Tutte puts every interior vertex at the mean of its neighbours") {
  const DiskChart chart = chartOf(bumpyGrid(8, 6, 0.7, 2));
  const std::vector<double> uv = embedTutte(chart).uv;
  std::vector<double> sum(uv.size(), 0), degree(chart.vertexCount(), 0);
  for (const ChartCorner h : chart.corners()) {
    const ChartVertex a = chart.vertexOfCorner[h], b = chart.vertexOfCorner[nextCorner(h)];
    for (std::size_t d = 0; d < 2; ++d) sum[2 * a + d] += uv[2 * b + d];
    ++degree[a];
  }
  const std::vector<bool> isInterior = interiorOf(chart);
  for (const ChartVertex v : chart.vertices())
    for (std::size_t d = 0; isInterior[v] && d < 2; ++d)
      CHECK(sum[2 * v + d] / degree[v] == Approx(uv[2 * v + d]).margin(1e-12));
}

TEST_CASE("harmonic: no interior vertex can lower the Dirichlet energy") {
  const DiskChart chart = chartOf(bumpyGrid(7, 6, 0.5, 3));
  std::vector<double> uv = onCircle(chart, harmonicWeights(chart)).uv;
  const std::vector<bool> isInterior = interiorOf(chart);
  const double step = 1e-4, energy = dirichlet(chart, uv);
  for (std::size_t i = 0; i < uv.size(); ++i) {
    if (!isInterior[i / 2]) continue;
    const double kept = uv[i];
    uv[i] = kept + step;
    const double above = dirichlet(chart, uv);
    uv[i] = kept - step;
    const double below = dirichlet(chart, uv);
    uv[i] = kept;
    CHECK(std::abs(above - below) / (2 * step) < 1e-8 * energy);
    CHECK(above + below > 2 * energy);
  }
}

TEST_CASE("all weights share an outline: a circle spaced by edge length") {
  const DiskChart chart = chartOf(bumpyGrid(9, 5, 0.4, 4));
  const std::vector<double> tutte = embedTutte(chart).uv;
  const std::vector<double> mean = onCircle(chart, meanValueWeights(chart)).uv;
  const std::vector<double> harmonic = onCircle(chart, harmonicWeights(chart)).uv;
  const double radius = std::sqrt(surfaceArea(chart) / kPi);
  double ratio = 0;
  for (const ChartCorner h : chart.boundary) {
    const ChartVertex a = chart.vertexOfCorner[h], b = chart.vertexOfCorner[nextCorner(h)];
    for (std::size_t d = 0; d < 2; ++d) {
      CHECK(mean[2 * a + d] == tutte[2 * a + d]);
      CHECK(harmonic[2 * a + d] == tutte[2 * a + d]);
    }
    CHECK(std::hypot(tutte[2 * a] - radius, tutte[2 * a + 1] - radius) == Approx(radius));
    const double chord =
        std::hypot(tutte[2 * a] - tutte[2 * b], tutte[2 * a + 1] - tutte[2 * b + 1]);
    const double arc = 2 * radius * std::asin(chord / (2 * radius));
    const double length = norm(edgeVector(chart.positions, a, b));
    if (ratio == 0) ratio = arc / length;
    CHECK(arc / length == Approx(ratio));
  }
}

TEST_CASE("Tutte and mean value flip no triangle of any sample") {
  for (const Sample& sample : samples()) {
    INFO(sample.name);
    const DiskChart chart = chartOf(sample.make(1));
    CHECK(checkValidity(chart, embedTutte(chart).uv).valid());
    const Embedding mean = onCircle(chart, meanValueWeights(chart));
    CHECK(mean.problem.empty());
    CHECK(checkValidity(chart, mean.uv).valid());
    for (const double w : meanValueWeights(chart).weight) CHECK(w >= 0);
  }
}

TEST_CASE("triangles of zero area give finite weights") {
  PolygonMesh collapsed = bumpyGrid(5, 5, 0.3, 5);
  // One interior vertex on top of its neighbour, and another in the middle of an edge.
  for (std::size_t d = 0; d < 3; ++d) {
    collapsed.positions[3 * 7 + d] = collapsed.positions[3 * 8 + d];
    collapsed.positions[3 * 21 + d] =
        (collapsed.positions[3 * 20 + d] + collapsed.positions[3 * 22 + d]) / 2;
  }
  const DiskChart chart = chartOf(collapsed);
  REQUIRE(checkValidity(chart, embedTutte(chart).uv).degenerateTriangles > 0);
  for (const HalfEdgeWeights& weights : {meanValueWeights(chart), harmonicWeights(chart)}) {
    for (const double w : weights.weight) CHECK(std::isfinite(w));
    const Embedding got = onCircle(chart, weights);
    CHECK(got.problem.empty());
    for (const double x : got.uv) CHECK(std::isfinite(x));
  }
}

TEST_CASE("weights that cannot be solved are a problem, not numbers") {
  const DiskChart chart = chartOf(bumpyGrid(4, 4, 0.3, 6));
  for (const bool isSymmetric : {true, false})
    for (const double weight : {0.0, std::nan("")}) {
      const HalfEdgeWeights bad{IdVector<ChartCorner, double>(chart.twin.size(), weight),
                                isSymmetric};
      CHECK_FALSE(onCircle(chart, bad).problem.empty());
    }
}

TEST_CASE("a single triangle has nothing to solve") {
  const DiskChart chart = chartOf(makeTriangleMesh({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}));
  for (const HalfEdgeWeights& weights : {meanValueWeights(chart), harmonicWeights(chart)}) {
    const Embedding got = onCircle(chart, weights);
    CHECK(got.problem.empty());
    CHECK(checkValidity(chart, got.uv).valid());
  }
}
