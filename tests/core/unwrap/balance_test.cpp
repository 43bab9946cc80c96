#include <algorithm>
#include <cmath>

#include "abflat/unwrap.h"
#include "base/constants.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

UnwrapOptions balanced(double balance) {
  UnwrapOptions out;
  out.balance = balance;
  return out;
}

/// Options for seams that do not depend on the balance.
UnwrapOptions asDisks(double balance) {
  UnwrapOptions out = balanced(balance);
  out.seams.isAuto = false;
  return out;
}

/// A sphere as three.js makes it, where each triangle at a pole has its own texcoord there.
PolygonMesh openSphere(std::uint32_t columns, std::uint32_t rows) {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i) {
      const double u = 2 * kPi * i / columns, v = kPi * j / rows;
      positions.insert(positions.end(),
                       {std::cos(u) * std::sin(v), std::cos(v), std::sin(u) * std::sin(v)});
    }
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, b = a + columns + 1;
      if (j > 0) triangles.insert(triangles.end(), {a, a + 1, b + 1});
      if (j + 1 < rows) triangles.insert(triangles.end(), {a, b + 1, b});
    }
  PolygonMesh out = makeTriangleMesh(positions, triangles);
  out.faceTexcoords = out.faceVertices;
  for (std::uint32_t v = 0; v < out.vertexCount(); ++v) {
    out.texcoords.push_back(v % (columns + 1));
    out.texcoords.push_back(v / (columns + 1));
  }
  return out;
}

}  // namespace

TEST_CASE("the more lengths count the less charts are stretched along the same seams",
          "[balance]") {
  for (const PolygonMesh& mesh : {torus(40, 24), bumpyGrid(24, 20, 0.9, 3)}) {
    double before = 1e9;
    for (const double balance : {0.0, 0.25, 0.5, 1.0}) {
      const UnwrapResult r = unwrapped(mesh, asDisks(balance));
      REQUIRE(r.report.valid);
      CHECK(r.report.symmetricDirichlet < before);
      before = r.report.symmetricDirichlet;
      for (const UnwrapChart& c : r.report.charts) {
        REQUIRE(c.refined.has_value() == (balance > 0));
        if (c.refined) CHECK(c.refined->energy < c.refined->energyBefore);
      }
    }
  }
}

TEST_CASE("with a balance fewer seams keep the bound", "[balance]") {
  for (const PolygonMesh& mesh : {torus(60, 30)}) {
    const UnwrapResult angles = unwrapped(mesh, balanced(0)),
                       lengths = unwrapped(mesh, balanced(1));
    REQUIRE(lengths.report.valid);
    CHECK(lengths.report.seams.relativeLength < angles.report.seams.relativeLength);
    for (const UnwrapChart& c : lengths.report.charts) CHECK(c.symmetricDirichlet <= 1.04);
  }
}

TEST_CASE("layouts for another balance are not taken over", "[balance]") {
  const PolygonMesh mesh = torus(24, 16);
  const UnwrapResult first = unwrapped(mesh, balanced(0.3));
  const auto solvers = [&](double balance) {
    UnwrapOptions options = balanced(balance);
    options.seams.isAuto = false;
    options.seams.edges = first.seams;
    options.reuse.known = knownLayout(first);
    const UnwrapResult r = unwrapped(mesh, options);
    return std::count_if(r.report.charts.begin(), r.report.charts.end(),
                         [](const UnwrapChart& c) { return c.solver == Solver::Known; });
  };
  CHECK(solvers(0.3) == static_cast<std::ptrdiff_t>(first.report.charts.size()));
  CHECK(solvers(0.4) == 0);
}

TEST_CASE("a sphere opened along a meridian and round its poles is refined", "[balance]") {
  const PolygonMesh mesh = openSphere(32, 16);
  for (const double balance : {0.2, 0.5, 1.0}) {
    UnwrapOptions options = asDisks(balance);
    options.seams.followsTexcoords = true;
    const UnwrapResult r = unwrapped(mesh, options);
    REQUIRE(r.report.charts.size() == 1);
    REQUIRE(r.report.charts[0].refined);
    const RefineReport& refined = *r.report.charts[0].refined;
    CAPTURE(balance, refined.steps, refined.limit);
    CHECK(refined.energy - 1 < 0.5 * (refined.energyBefore - 1));
    CHECK(refined.steps <= 15);
  }
}

TEST_CASE("a chart without stretch is not refined", "[balance]") {
  const UnwrapResult r = unwrapped(tetrahedron(), balanced(1));
  for (const UnwrapChart& c : r.report.charts) CHECK(!c.refined);
}
