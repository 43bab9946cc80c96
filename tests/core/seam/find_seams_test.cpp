#include <limits>

#include "abflat/flatten.h"
#include "abflat/unwrap.h"
#include "catch.h"
#include "mesh/triangle_geometry.h"
#include "support/cut_meshes.h"
#include "support/isosurface.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A square of n x n spikes, each of which needs a slit or a seam of its own.
PolygonMesh spikes(unsigned n) {
  const unsigned side = 3 * n + 1;
  std::vector<double> positions;
  for (unsigned j = 0; j < side; ++j)
    for (unsigned i = 0; i < side; ++i)
      positions.insert(positions.end(), {1.0 * i, 1.0 * j, i % 3 == 1 && j % 3 == 1 ? 3.0 : 0.0});
  std::vector<std::uint32_t> triangles;
  for (unsigned j = 0; j + 1 < side; ++j)
    for (unsigned i = 0; i + 1 < side; ++i) {
      const std::uint32_t a = j * side + i;
      triangles.insert(triangles.end(), {a, a + 1, a + side + 1, a, a + side + 1, a + side});
    }
  return makeTriangleMesh(std::move(positions), std::move(triangles));
}

struct Flattened {
  double stretch = 0;  ///< symmetric Dirichlet / 4, area-weighted mean
  std::size_t invalid = 0;
};

double areaOf(const PolygonMesh& mesh) {
  double area = 0;
  for (std::size_t c = 0; c < mesh.faceVertices.size(); c += 3) {
    const std::uint32_t* v = &mesh.faceVertices[c];
    area += norm(cross(edgeVector(mesh.positions, v[0], v[1]),
                       edgeVector(mesh.positions, v[0], v[2]))) /
            2;
  }
  return area;
}

Flattened flattened(const Cuttable& c, const Seams& seams) {
  Flattened out;
  double area = 0;
  for (const PolygonMesh& chart : chartsOf(c, seams)) {
    FlattenOptions options;
    options.t = kAutoT;
    const Result<FlattenResult> flat = flatten(chart, options);
    REQUIRE(flat.ok());
    const double own = areaOf(chart);
    area += own;
    out.stretch += own * flat.value().report.charts[0].symmetricDirichlet;
    out.invalid += !flat.value().report.valid;
  }
  out.stretch /= area;
  return out;
}

}  // namespace

TEST_CASE("charts flatten validly, as little distorted as was predicted", "[seams][quality]") {
  const PolygonMesh meshes[] = {isosurface(24, rings(0)), isosurface(26, rings(1)),
                                isosurface(30, rings(3)), isosurface(28, noise(2, 4)),
                                torus(24, 60)};
  for (const PolygonMesh& mesh : meshes) {
    const Cuttable c(mesh);
    SeamReport report;
    const Seams seams = findSeams(c.seamMesh, {}, {}, &report);
    const Flattened flat = flattened(c, seams);
    CAPTURE(report.charts, report.seamLength, report.stretch);
    CHECK(flat.invalid == 0);
    CHECK(report.stretch <= SeamOptions().maxStretch);
    CHECK(flat.stretch < report.stretch + 0.05);
  }
}

TEST_CASE("a smaller bound means longer seams and less distortion", "[seams][quality]") {
  const Cuttable c(isosurface(28, noise(2, 7)));
  double length = 0, stretch = 10;
  for (const double bound : {1.08, 1.03, 1.008}) {
    SeamOptions options;
    options.maxStretch = bound;
    SeamReport report;
    findSeams(c.seamMesh, {}, options, &report);
    CHECK(report.stretch <= bound);
    CHECK(report.seamLength > length);
    CHECK(report.stretch < stretch);
    length = report.seamLength;
    stretch = report.stretch;
  }
}

TEST_CASE("seams do not depend on unit or place, nor on threads", "[seams]") {
  for (const PolygonMesh& mesh : {isosurface(22, rings(2)), torus(20, 40)}) {
    const Cuttable c(mesh);
    const Seams seams = findSeams(c.seamMesh, {}, {}, nullptr);
    for (const double scale : {1e-6, 1e6, 3.7}) {
      CAPTURE(scale);
      PolygonMesh scaled = mesh;
      for (double& x : scaled.positions) x *= scale;
      CHECK(findSeams(Cuttable(scaled).seamMesh, {}, {}, nullptr) == seams);
    }
    ThreadPool pool(3);
    SeamOptions options;
    options.pool = &pool;
    CHECK(findSeams(c.seamMesh, {}, options, nullptr) == seams);
  }
}

TEST_CASE("what is flat or a disk already is not cut", "[seams]") {
  for (const PolygonMesh& mesh : {star(9), bumpyGrid(12, 9, 0, 2), cone(30, 0.1)}) {
    const Cuttable c(mesh);
    SeamReport report;
    findSeams(c.seamMesh, {}, {}, &report);
    CHECK(report.charts == 1);
    CHECK(report.seamLength == 0);
  }
}

TEST_CASE("a disk stays whole where only what topology needs is cut", "[seams]") {
  const Cuttable c(cone(40, 4));
  SeamOptions options;
  SeamReport report;
  findSeams(c.seamMesh, {}, options, &report);
  CHECK(report.seamLength > 0);
  options.isAuto = false;
  findSeams(c.seamMesh, {}, options, &report);
  CHECK(report.seamLength == 0);
}

TEST_CASE("a cylinder is cut along its height, a torus along its two loops", "[seams]") {
  SeamReport report;
  const Cuttable tube(cylinder(40, 12));
  findSeams(tube.seamMesh, {}, {}, &report);
  CHECK(report.charts == 1);
  double height = 0;
  for (std::size_t v = 0; v + 40 < tube.mesh.vertexCount(); v += 40)
    height += norm(edgeVector(tube.mesh.positions, static_cast<std::uint32_t>(v),
                              static_cast<std::uint32_t>(v + 40)));
  CHECK(report.seamLength * std::sqrt(areaOf(tube.mesh)) == Approx(height));
  CHECK(report.handleLoops == 0);
  const Cuttable ring(torus(24, 60));
  SeamOptions whole;  // half a torus has no handle
  whole.symmetricSeams = SymmetricSeams::Never;
  findSeams(ring.seamMesh, {}, whole, &report);
  CHECK(report.handleLoops == 2);
}

TEST_CASE("finding seams stops when it is told to, with charts that are disks", "[seams]") {
  const Cuttable c(isosurface(24, rings(2)));
  SeamOptions options;
  int asked = 0;
  options.listener = Listener([&](const Progress&) { return ++asked < 2; });
  SeamReport report;
  const Seams seams = findSeams(c.seamMesh, {}, options, &report);
  CHECK(options.listener.isStopped());
  for (const PolygonMesh& chart : chartsOf(c, seams)) CHECK(inspect(chart).disk.ok());
}

TEST_CASE("rounds hardly grow with the number of peaks", "[seams][quality]") {
  const auto roundsFor = [](unsigned n) {
    const Cuttable c(spikes(n));
    SeamReport report;
    findSeams(c.seamMesh, {}, {}, &report);
    CHECK(report.stretch <= SeamOptions().maxStretch);
    return report.rounds;
  };
  const auto few = roundsFor(10), many = roundsFor(40);
  CAPTURE(few, many);
  CHECK(many <= 2 * few);
}

TEST_CASE("seams of real meshes meet the yardsticks", "[seams][quality]") {
  // Charts and length that xatlas gives with its defaults on the same meshes.
  struct Yardstick {
    const char* file;
    double charts, length;
  };
  const Yardstick yardsticks[] = {
      {"bunny-closed.off", 58, 15.04},  {"fertility-genus4.off", 45, 18.16},
      {"genus3.off", 29, 13.91},        {"spot-uv.obj", 39, 12.29},
      {"suzanne-quads.obj", 70, 14.41}, {"teapot-5parts.obj", 47, 9.82}};
  for (const Yardstick& y : yardsticks) {
    PolygonMesh mesh = sharedMesh(y.file);
    if (mesh.faceCount() == 0) continue;
    UnwrapOptions options;
    options.seamCosts = SeamCosts::Length;
    const Result<UnwrapResult> r = unwrap(mesh, options);
    INFO(y.file);
    REQUIRE(r.ok());
    const UnwrapReport& report = r.value().report;
    CHECK(report.valid);
    CHECK(static_cast<double>(report.charts.size()) <= 0.3 * y.charts);
    CHECK(report.seams.relativeLength <= 0.56 * y.length);
    CHECK(report.symmetricDirichlet <= UnwrapOptions().maxStretch);
  }
}

namespace {

/// Octahedra far apart, with corners at different distances from their middles.
PolygonMesh specks(unsigned count) {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;
  unsigned seed = 1;
  for (unsigned i = 0; i < count; ++i) {
    for (unsigned k = 0; k < 6; ++k) {
      seed = seed * 1664525u + 1013904223u;
      Vec3 at{10. * i, 0, 0};
      at[k / 2] += (k % 2 ? -1 : 1) * (0.5 + (seed >> 8) / 16777216.0);
      positions.insert(positions.end(), at.begin(), at.end());
    }
    for (const std::uint32_t v :
         {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5})
      triangles.push_back(6 * i + v);
  }
  return makeTriangleMesh(std::move(positions), std::move(triangles));
}

}  // namespace

TEST_CASE("specks stay in one piece", "[seams]") {
  constexpr unsigned kCount = 40;
  const Cuttable c(specks(kCount));
  SeamOptions options;
  SeamReport apart, together;
  findSeams(c.seamMesh, {}, options, &apart);
  options.speck = std::numeric_limits<double>::infinity();
  const Seams seams = findSeams(c.seamMesh, {}, options, &together);
  CHECK(together.charts >= kCount);
  CHECK(together.charts <= 1.25 * kCount);
  CHECK(together.charts < 0.8 * apart.charts);
  const Flattened flat = flattened(c, seams);
  CHECK(flat.invalid == 0);
  CHECK(flat.stretch <= options.maxStretch);
}
