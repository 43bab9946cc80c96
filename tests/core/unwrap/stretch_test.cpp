#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "abflat/unwrap.h"
#include "catch.h"
#include "mesh/triangle_geometry.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A closed surface where the log-scale predicts less than half of the actual stretch.
PolygonMesh roughTorus() {
  PolygonMesh mesh = torus(48, 32);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double noise = std::sin(12.9898 * static_cast<double>(i)) * 43758.5453;
    mesh.positions[i] += 0.025 * (noise - std::floor(noise) - 0.5);
  }
  return mesh;
}

std::vector<PolygonMesh> meshes() {
  std::vector<PolygonMesh> out = {torus(24, 16), roughTorus(), bumpyGrid(24, 20, 0.9, 3)};
  for (const char* file : {"suzanne-quads.obj", "mannequin.off", "bunny-closed.off",
                           "beetle-nonmanifold.obj", "camel-cut.obj"})
    if (PolygonMesh mesh = sharedMesh(file); mesh.faceCount() > 0) out.push_back(std::move(mesh));
  return out;
}

double mostStretch(const UnwrapResult& r) {
  double most = 1;
  for (const UnwrapChart& chart : r.report.charts) most = std::max(most, chart.symmetricDirichlet);
  return most;
}

/// The triangles whose vertices are all beyond that in z.
PolygonMesh inFront(const PolygonMesh& mesh, double z) {
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < mesh.faceVertices.size(); i += 3) {
    const auto begin = mesh.faceVertices.begin() + static_cast<std::ptrdiff_t>(i);
    const auto isInFront = [&](std::uint32_t v) {
      return mesh.positions[3 * std::size_t{v} + 2] > z;
    };
    if (std::all_of(begin, begin + 3, isInFront)) kept.insert(kept.end(), begin, begin + 3);
  }
  return makeTriangleMesh(mesh.positions, std::move(kept));
}

bool hasNote(const UnwrapResult& r, const std::string& part) {
  return std::any_of(r.report.notes.begin(), r.report.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("no chart is stretched more than is allowed, once it is flat", "[unwrap][quality]") {
  for (const PolygonMesh& mesh : meshes())
    for (const double bound : {1.02, 1.04, 1.15}) {
      UnwrapOptions options;
      options.maxStretch = bound;
      options.frontLeeway = 1;
      const UnwrapResult result = unwrapped(mesh, options);
      CHECK(mostStretch(result) <= bound);
      CHECK_FALSE(hasNote(result, "stretched"));
    }
}

TEST_CASE("the front of a figure is stretched more rather than cut", "[unwrap]") {
  const PolygonMesh ball = dentedBall({0, 0, 1});
  const auto seamsInFront = [&](const UnwrapResult& r) {
    double length = 0;
    for (const EdgeVertices& edge : r.seams) {
      const auto [a, b] = edge;
      const double* const p = &ball.positions[3 * std::size_t{a}];
      if (p[2] > 0.7 * norm({p[0], p[1], p[2]})) length += norm(edgeVector(ball.positions, a, b));
    }
    return length;
  };
  UnwrapOptions options;
  options.frontLeeway = 1;
  const UnwrapResult strict = unwrapped(ball, options);
  CHECK(mostStretch(strict) <= options.maxStretch);
  options.frontLeeway = 8;
  const UnwrapResult lenient = unwrapped(ball, options);
  CHECK(mostStretch(lenient) > options.maxStretch);
  CHECK(mostStretch(lenient) <= 1 + 8 * (options.maxStretch - 1));
  CHECK(hasNote(lenient, "in the front of a figure"));
  CHECK(seamsInFront(strict) > 0.5);
  CHECK(seamsInFront(lenient) < 0.1 * seamsInFront(strict));
}

TEST_CASE("a mask is not cut at all, and may be stretched half as much again", "[unwrap]") {
  const PolygonMesh mask = inFront(dentedBall({0, 0, 1}), 0.1);
  UnwrapOptions options;
  options.frontLeeway = 1;
  CHECK_FALSE(unwrapped(mask, options).seams.empty());
  options.frontLeeway = 8;
  const UnwrapResult result = unwrapped(mask, options);
  CHECK(result.seams.empty());
  REQUIRE(result.report.charts.size() == 1);
  const UnwrapChart& chart = result.report.charts.front();
  CHECK(chart.symmetricDirichlet > options.maxStretch);
  CHECK(chart.symmetricDirichlet <= 1 + chart.leeway * (options.maxStretch - 1));
  CHECK(chart.leeway <= 1 + 1.5 * (options.frontLeeway - 1));
}

TEST_CASE("a front is stretched and sheared within its leeway", "[unwrap][quality]") {
  for (const PolygonMesh& mesh : meshes())
    for (const UnwrapChart& chart : unwrapped(mesh, {}).report.charts) {
      CHECK(chart.leeway >= 1);
      CHECK(chart.leeway <= UnwrapOptions().frontLeeway);
      CHECK(chart.symmetricDirichlet <= 1 + 0.02 * chart.leeway);
      CHECK(chart.quasiConformalSheared <= 0.1 * chart.leeway);
    }
}

TEST_CASE("no more of a chart is sheared than is allowed", "[unwrap][quality]") {
  const auto mostSheared = [](const UnwrapResult& r) {
    double most = 0;
    for (const UnwrapChart& chart : r.report.charts)
      most = std::max(most, chart.quasiConformalSheared);
    return most;
  };
  for (const PolygonMesh& mesh : meshes()) {
    UnwrapOptions options;
    options.frontLeeway = 1;
    CHECK(mostSheared(unwrapped(mesh, options)) <= 0.1);
    options.maxSheared = 0.03;
    const UnwrapResult result = unwrapped(mesh, options);
    CHECK(mostSheared(result) <= 0.03);
    CHECK(result.report.sheared <= 0.03);
    CHECK_FALSE(hasNote(result, "sheared"));
  }
}

TEST_CASE("shear is not limited where that is not asked for", "[unwrap]") {
  const PolygonMesh mesh = bumpyGrid(24, 20, 0.9, 3);
  UnwrapOptions options;
  options.maxStretch = 1.5;
  const UnwrapResult as = unwrapped(mesh, options);
  CHECK(as.report.charts.size() == 1);
  CHECK(as.report.sheared > 0.1);
  CHECK_FALSE(hasNote(as, "sheared"));
  options.t = 1;
  options.maxSheared = 0.01;
  CHECK(hasNote(unwrapped(mesh, options), "sheared over a share of more than 0.01"));
}

TEST_CASE("cutting further does not depend on threads, and known charts give the same",
          "[unwrap]") {
  const PolygonMesh mesh = roughTorus();
  UnwrapOptions options;
  options.minUtilization = 0;  // charts cut by packing are flattened again
  options.threads = 1;
  const UnwrapResult one = unwrapped(mesh, options);
  options.threads = 2;
  const UnwrapResult two = unwrapped(mesh, options);
  CHECK(one.uv == two.uv);
  CHECK(one.cornerUv == two.cornerUv);
  options.reuse.known = knownLayout(one);
  const UnwrapResult again = unwrapped(mesh, options);
  CHECK(one.uv == again.uv);
  CHECK(one.report.symmetricDirichlet == again.report.symmetricDirichlet);
  CHECK(std::all_of(again.report.charts.begin(), again.report.charts.end(),
                    [](const UnwrapChart& c) { return c.solver == Solver::Known; }));
}

TEST_CASE("what the user's own bounds stretch is said, and not cut for", "[unwrap]") {
  const PolygonMesh mesh = torus(24, 16);
  UnwrapOptions options;
  options.maxStretch = 1.02;
  const std::size_t charts = unwrapped(mesh, options).report.charts.size();
  const auto check = [&](const std::string& reason) {
    const UnwrapResult result = unwrapped(mesh, options);
    CHECK(result.report.charts.size() <= charts);
    REQUIRE(mostStretch(result) > options.maxStretch);
    CHECK(hasNote(result, " stretched by more than 1.02, up to "));
    CHECK(hasNote(result, reason));
  };
  SECTION("convex") {
    options.t = 1;
    check("a larger t, or auto, stretches less");
  }
  SECTION("straight seams") {
    options.straightSeams = true;
    check("straight seams force that");
  }
  SECTION("without automatic seams nothing is promised") {
    options.seams.isAuto = false;
    const UnwrapResult result = unwrapped(mesh, options);
    CHECK_FALSE(hasNote(result, "stretched"));
  }
}
