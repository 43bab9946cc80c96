#include "abflat/flatten.h"

#include <cmath>

#include "abflat/samples.h"
#include "base/constants.h"
#include "catch.h"
#include "check/distortion.h"
#include "check/validity.h"
#include "support/instrumented.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

FlattenResult flattened(const PolygonMesh& mesh, double t) {
  FlattenOptions options;
  options.t = t;
  const Result<FlattenResult> r = flatten(mesh, options);
  INFO(r.status().message);
  REQUIRE(r.ok());
  return r.value();
}

/// Lengths of all triangle edges in uv, which no motion of the plane changes.
std::vector<double> edgeLengths(const FlattenResult& r, const std::vector<std::uint32_t>& corners) {
  std::vector<double> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t a = r.cornerUv[corners[i]],
                        b = r.cornerUv[corners[3 * (i / 3) + (i + 1) % 3]];
    out.push_back(std::hypot(r.uv[2 * a] - r.uv[2 * b], r.uv[2 * a + 1] - r.uv[2 * b + 1]));
  }
  return out;
}

/// About 4000 faces times `detail`.
PolygonMesh head(double detail) {
  for (const Sample& sample : samples())
    if (sample.name == "head") return sample.make(detail);
  return {};
}

std::vector<std::uint32_t> identity(std::size_t n) {
  std::vector<std::uint32_t> out(n);
  for (std::size_t i = 0; i < n; ++i) out[i] = static_cast<std::uint32_t>(i);
  return out;
}

}  // namespace

TEST_CASE("the values of the paper's models are met to all digits") {
  struct Row {
    const char* file;
    double t, angular, length;
  };
  const Row rows[] = {
      {"nefertiti.off", 2, 0.00170, 0.0132}, {"nefertiti.off", 1.05, 0.00216, 0.0175},
      {"nefertiti.off", 1, 0.00252, 0.0181}, {"nefertiti.off", 0.968, 0.00298, 0.0192},
      {"body.off", 2, 0.01135, 1.6502},      {"body.off", 1.05, 0.01139, 1.6675},
      {"body.off", 1, 0.01144, 1.6776},      {"body.off", 0.968, 0.01147, 1.6918},
      {"cathead.obj", 2, 0.03063, 0.4782},   {"cathead.obj", 1, 0.03063, 0.4782},
  };
  for (const Row& row : rows) {
    const PolygonMesh mesh = sharedMesh(row.file);
    if (mesh.faceCount() == 0) return;
    const FlattenResult r = flattened(mesh, row.t);
    const ChartReport& chart = r.report.charts.front();
    INFO(row.file << " t = " << row.t);
    CHECK(r.report.valid);
    CHECK(chart.constraintResidual <= 1e-10);
    CHECK(std::abs(chart.angularDistortion - row.angular) <= 0.5001e-5);
    CHECK(std::abs(chart.lengthDistortion - row.length) <= 0.5001e-4);
    CHECK(chart.maxBoundaryAngle <= row.t * kPi + 1e-8);
  }
}

TEST_CASE("a free boundary that crosses itself is reported, not hidden") {
  const PolygonMesh mesh = sharedMesh("camel-cut.obj");
  if (mesh.faceCount() == 0) return;
  const FlattenResult r = flattened(mesh, 2);
  CHECK(r.report.charts.front().boundaryCrossings == 1);
  CHECK(r.report.charts.front().converged);
  CHECK_FALSE(r.report.valid);
}

TEST_CASE("results do not depend on scale, position and rotation") {
  const PolygonMesh mesh = bumpyGrid(12, 10, 0.4, 1);
  const std::vector<std::uint32_t> corners = identity(mesh.faceVertices.size());
  for (double t : {2.0, 1.0}) {
    const std::vector<double> wanted = edgeLengths(flattened(mesh, t), corners);
    for (double scale : {1e-9, 0.37, 1e12}) {
      const PolygonMesh moved = transformed(mesh, scale, {2 * scale, -scale, 5 * scale});
      const std::vector<double> got = edgeLengths(flattened(moved, t), corners);
      for (std::size_t i = 0; i < got.size(); ++i)
        CHECK(std::abs(got[i] / scale - wanted[i]) < 1e-8 * 12);
    }
  }
}

TEST_CASE("results do not depend on how vertices and faces are numbered") {
  const PolygonMesh mesh = bumpyGrid(12, 10, 0.4, 2);
  for (double t : {2.0, 1.0})
    for (unsigned seed : {1u, 2u}) {
      const Renumbered other = renumbered(mesh, seed);
      const FlattenResult a = flattened(mesh, t), b = flattened(other.mesh, t);
      const std::vector<double> wanted = edgeLengths(a, identity(mesh.faceVertices.size()));
      const std::vector<double> got = edgeLengths(b, other.corner);
      for (std::size_t i = 0; i < got.size(); ++i) CHECK(std::abs(got[i] - wanted[i]) < 1e-8 * 12);
      // The pose of the layout is part of the result.
      for (std::size_t c = 0; c < other.corner.size(); ++c)
        for (std::size_t d = 0; d < 2; ++d)
          CHECK(std::abs(a.uv[2 * a.cornerUv[c] + d] - b.uv[2 * b.cornerUv[other.corner[c]] + d]) <
                1e-7 * 12);
    }
}

TEST_CASE("the layout has the area of the surface") {
  const PolygonMesh mesh = bumpyGrid(10, 10, 0.4, 3);
  const FlattenResult r = flattened(mesh, 1);
  double uv = 0, surface = 0;
  for (std::size_t f = 0; f < r.triangles.size(); f += 3) {
    const auto at = [&](std::size_t k, std::size_t d) { return r.uv[2 * r.triangles[f + k] + d]; };
    uv += ((at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) -
           (at(1, 1) - at(0, 1)) * (at(2, 0) - at(0, 0))) /
          2;
    const auto p = [&](std::size_t k, std::size_t d) {
      return mesh.positions[3 * r.vertexMap[r.triangles[f + k]] + d];
    };
    double n[3];
    for (std::size_t d = 0; d < 3; ++d) {
      const std::size_t e = (d + 1) % 3, g = (d + 2) % 3;
      n[d] = (p(1, e) - p(0, e)) * (p(2, g) - p(0, g)) - (p(1, g) - p(0, g)) * (p(2, e) - p(0, e));
    }
    surface += std::hypot(n[0], n[1], n[2]) / 2;
  }
  CHECK(uv == Approx(surface));
}

TEST_CASE("the report holds for the coordinates that are returned, of any magnitude") {
  // The last two lose digits when the layout is scaled to the mesh's unit.
  for (const double scale : {1.0, 3e7, 1e250, 1e-120, 1e-306, 1e-310}) {
    const PolygonMesh mesh = transformed(bumpyGrid(12, 9, 0.7, 5), scale, {0, 0, 0});
    const FlattenResult r = flattened(mesh, 2);
    const ChartReport& c = r.report.charts.front();
    const DiskChart chart = chartOf(mesh);
    std::vector<double> uv = r.uv;
    for (double& x : uv) x /= chart.unit;
    const Distortion d = measureDistortion(chart, uv);
    const Validity v = checkValidity(chart, uv);
    INFO(scale);
    CHECK(v.valid());
    CHECK(c.angularDistortion == d.angular);
    CHECK(c.lengthDistortion == d.length);
    CHECK(c.quasiConformalMean == d.quasiConformalMean);
    CHECK(c.quasiConformalMax == d.quasiConformalMax);
    CHECK(c.stretchL2 == d.stretchL2);
    CHECK(c.stretchLinf == d.stretchLinf);
    CHECK(c.symmetricDirichlet == d.symmetricDirichlet);
    CHECK(c.areaDistortionMin == d.areaMin);
    CHECK(c.areaDistortionMax == d.areaMax);
    CHECK(c.flippedTriangles == v.flippedTriangles);
    CHECK(c.boundaryCrossings == v.crossings.count);
    CHECK(c.maxBoundaryAngle == v.maxBoundaryAngle);
  }
}

TEST_CASE("two runs give the same bytes") {
  const PolygonMesh mesh = bumpyGrid(20, 20, 0.4, 4);
  const FlattenResult a = flattened(mesh, 1), b = flattened(mesh, 1);
  CHECK(a.uv == b.uv);
  CHECK(a.cornerUv == b.cornerUv);
}

TEST_CASE("the smallest disks are flattened") {
  const std::vector<double> p{0, 0, 0, 2, 0, 0, 0, 1, 0, 2, 1, 1};
  CHECK(flattened(makeTriangleMesh(p, {0, 1, 2}), 1).report.valid);
  CHECK(flattened(makeTriangleMesh(p, {0, 1, 2, 2, 1, 3}), 1).report.valid);
  CHECK(flattened(cone(3, 1), 1).report.valid);
  CHECK(flattened(cone(12, 0.2), 1).report.valid);
  CHECK(flattened(star(7), 1).report.valid);
}

TEST_CASE("faces of zero area do not spoil the layout") {
  // The middle of the long edge is a vertex, so the second face is flat.
  const PolygonMesh mesh = makeTriangleMesh({0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0, 1, -1, 0},
                                            {0, 2, 3, 0, 1, 2, 0, 4, 1, 1, 4, 2});
  const FlattenResult r = flattened(mesh, 2);
  CHECK(r.report.valid);
  CHECK(r.report.charts.front().degenerateTriangles == 1);
  CHECK(std::isfinite(r.report.charts.front().symmetricDirichlet));
}

TEST_CASE("options and bounds out of range are refused with the least possible t") {
  const auto code = [](const PolygonMesh& mesh, double t) {
    FlattenOptions options;
    options.t = t;
    return flatten(mesh, options).status().code;
  };
  for (double t : {-1.0, std::nan(""), HUGE_VAL})
    CHECK(code(cone(8, 1), t) == StatusCode::InvalidOption);
  CHECK(code(cone(8, 1), 0.74) == StatusCode::InfeasibleBound);
  CHECK(code(cone(8, 1), 0.76) == StatusCode::Ok);
  FlattenOptions options;
  options.t = 0.5;
  CHECK(flatten(cone(8, 1), options).status().message.find("0.75") != std::string::npos);
  CHECK(code(tetrahedron(), 1) == StatusCode::ClosedSurface);
  CHECK(code(PolygonMesh{}, 1) == StatusCode::EmptyMesh);
}

TEST_CASE("progress is called through all stages and can cancel in each") {
  const PolygonMesh mesh = bumpyGrid(8, 8, 0.3, 1);
  std::vector<Stage> stages;
  double last = -1;
  FlattenOptions options;
  options.progress = [&](const Progress& p) {
    stages.push_back(p.stage);
    CHECK(p.fraction >= last);
    CHECK(p.fraction <= 1);
    last = p.fraction;
    return true;
  };
  CHECK(flatten(mesh, options).ok());
  CHECK(stages.front() == Stage::Connectivity);
  CHECK(stages.back() == Stage::Check);
  for (std::size_t stop = 0; stop < stages.size(); ++stop) {
    std::size_t calls = 0;
    options.progress = [&](const Progress&) { return calls++ != stop; };
    CHECK(flatten(mesh, options).status().code == StatusCode::Aborted);
    CHECK(calls == stop + 1);
  }
}

TEST_CASE("the factorisation of Eigen gives the same layout and is reported") {
  const PolygonMesh mesh = bumpyGrid(8, 7, 0.3, 5);
  const FlattenResult wanted = flattened(mesh, 1);
  FlattenOptions options;
  options.t = 1;
  options.linearSolver = LinearSolver::Eigen;
  const Result<FlattenResult> eigen = flatten(mesh, options);
  REQUIRE(eigen.ok());
  CHECK(eigen.value().report.charts.front().linearSolver == LinearSolver::Eigen);
  for (std::size_t i = 0; i < wanted.uv.size(); ++i)
    CHECK(std::abs(eigen.value().uv[i] - wanted.uv[i]) < 1e-9);
  options.formulation = Formulation::Product;
  CHECK(flatten(mesh, options).status().code == StatusCode::InvalidOption);
  options.linearSolver = LinearSolver::Schur;
  CHECK(flatten(mesh, options).status().code == StatusCode::InvalidOption);
}

TEST_CASE("a result is the same to the last bit for any number of threads", "[flatten][threads]") {
  const PolygonMesh mesh = head(9);
  REQUIRE(mesh.faceCount() > 33000);  // enough for assembly to be divided among threads
  for (const double t : {1.0, 2.0}) {
    if (kIsInstrumented && t > 1) continue;
    FlattenOptions options;
    options.t = t;
    FlattenResult wanted;
    for (const int threads : {1, 2, 3}) {
      if (kIsInstrumented && threads == 2) continue;
      INFO(threads << " threads, t = " << t);
      options.threads = threads;
      Result<FlattenResult> r = flatten(mesh, options);
      REQUIRE(r.ok());
      CHECK(r.value().report.threads == static_cast<unsigned>(threads));
      if (threads == 1) wanted = std::move(r.value());
      if (threads == 1) continue;
      CHECK(r.value().uv == wanted.uv);
      const auto &history = r.value().report.charts[0].history,
                 &wantedHistory = wanted.report.charts[0].history;
      REQUIRE(history.size() == wantedHistory.size());
      for (std::size_t i = 0; i < history.size(); ++i) {
        CHECK(history[i].objective == wantedHistory[i].objective);
        CHECK(history[i].constraint == wantedHistory[i].constraint);
        CHECK(history[i].gradient == wantedHistory[i].gradient);
      }
    }
  }
}

TEST_CASE("a run on several threads can be cancelled", "[flatten][threads]") {
  const PolygonMesh mesh = head(3);
  FlattenOptions options;
  options.threads = 3;
  for (int stop = 0; stop < 4; ++stop) {
    int steps = 0;
    options.progress = [&](const Progress& p) { return p.newtonStep == 0 || steps++ != stop; };
    CHECK(flatten(mesh, options).status().code == StatusCode::Aborted);
  }
}
