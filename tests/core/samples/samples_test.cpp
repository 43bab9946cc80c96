#include "abflat/samples.h"

#include <cmath>
#include <set>

#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "catch.h"

using namespace abflat;

namespace {

const Sample& sampleNamed(std::string_view name) {
  for (const Sample& sample : samples())
    if (sample.name == name) return sample;
  FAIL("there is no sample " << name);
  return samples().front();
}

ChartReport flattened(const PolygonMesh& mesh, double t) {
  FlattenOptions options;
  options.t = t;
  const Result<FlattenResult> r = flatten(mesh, options);
  INFO(r.status().message);
  REQUIRE(r.ok());
  return r.value().report.charts.front();
}

/// Ratio of the longest edge to the height above it.
double thinness(const PolygonMesh& mesh, std::size_t f) {
  double p[3][3], longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t d = 0; d < 3; ++d)
      p[k][d] = mesh.positions[3 * mesh.faceVertices[3 * f + k] + d];
  double u[3], w[3];
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t d = 0; d < 3; ++d) {
      u[d] = p[(k + 1) % 3][d] - p[k][d];
      w[d] = p[(k + 2) % 3][d] - p[k][d];
    }
    longest = std::max(longest, std::hypot(u[0], u[1], u[2]));
  }
  const double twiceArea =
      std::hypot(u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]);
  return longest * longest / twiceArea;
}

}  // namespace

TEST_CASE("samples are disks of well shaped triangles") {
  for (const Sample& sample : samples()) {
    INFO(sample.name);
    const PolygonMesh mesh = sample.make(1);
    const MeshSummary summary = inspect(mesh);
    INFO(summary.disk.message);
    CHECK(summary.disk.ok());
    CHECK(summary.degenerateFaces == 0);
    CHECK(summary.unreferencedVertices == 0);
    CHECK(summary.faces >= 1000);
    CHECK(summary.faces <= 4500);
    double worst = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) worst = std::max(worst, thinness(mesh, f));
    CHECK(worst < 20);
  }
}

TEST_CASE("samples have finite coordinates and different names") {
  std::set<std::string_view> names;
  for (const Sample& sample : samples()) {
    INFO(sample.name);
    CHECK(names.insert(sample.name).second);
    CHECK_FALSE(sample.title.empty());
    bool finite = true;
    for (double x : sample.make(1).positions) finite = finite && std::isfinite(x);
    CHECK(finite);
  }
}

TEST_CASE("faces of samples grow linearly with detail and stay a disk") {
  for (const Sample& sample : samples())
    for (double detail : {2.0, 5.5}) {
      INFO(sample.name << " detail " << detail);
      const PolygonMesh mesh = sample.make(detail);
      const double growth =
          static_cast<double>(mesh.faceCount()) / static_cast<double>(sample.make(1).faceCount());
      CHECK(growth > 0.8 * detail);
      CHECK(growth < 1.25 * detail);
      CHECK(inspect(mesh).disk.ok());
      CHECK(inspect(mesh).degenerateFaces == 0);
    }
}

TEST_CASE("samples flatten freely and with a convex boundary") {
  for (const Sample& sample : samples()) {
    INFO(sample.name);
    const PolygonMesh mesh = sample.make(1);
    const ChartReport free = flattened(mesh, 2), convex = flattened(mesh, 1);
    CHECK(free.converged);
    CHECK(free.flippedTriangles == 0);
    CHECK(convex.valid);
    // Bounds can only cost: the free minimum is taken over a larger set.
    CHECK(free.history.back().objective <= convex.history.back().objective * (1 + 1e-6));
  }
}

TEST_CASE("the hemisphere is exact") {
  const PolygonMesh mesh = sampleNamed("hemisphere").make(1);
  double lowest = 1;
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    const double* p = &mesh.positions[3 * v];
    CHECK(std::abs(std::hypot(p[0], p[1], p[2]) - 1) < 1e-15);
    lowest = std::min(lowest, p[1]);
  }
  CHECK(std::abs(lowest) < 1e-15);
}

TEST_CASE("the free layout of the alpha band overlaps itself and the convex one does not") {
  for (double detail : {1.0, 3.0}) {
    const PolygonMesh mesh = sampleNamed("alpha-band").make(detail);
    const ChartReport free = flattened(mesh, 2), convex = flattened(mesh, 1);
    CHECK(free.boundaryCrossings > 0);
    CHECK_FALSE(free.valid);
    CHECK(convex.boundaryCrossings == 0);
    CHECK(convex.valid);
  }
}

TEST_CASE("the strands of the alpha band pass over each other without touching") {
  const PolygonMesh mesh = sampleNamed("alpha-band").make(1);
  // Near the origin of the plan view there are only the two strands, at different heights.
  double highest = -1, lowest = 1, gap = 1;
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    const double* p = &mesh.positions[3 * v];
    if (std::hypot(p[0], p[2]) > 0.2) continue;
    highest = std::max(highest, p[1]);
    lowest = std::min(lowest, p[1]);
    gap = std::min(gap, std::abs(p[1]));
  }
  CHECK(highest > 0.1);
  CHECK(lowest < -0.1);
  CHECK(gap > 0.05);
}
