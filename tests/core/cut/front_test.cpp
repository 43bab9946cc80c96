#include "cut/front.h"

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "cut/edge_bends.h"
#include "mesh/triangle_geometry.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A ball with hollows around a direction, as eyes, cheeks and a mouth.
PolygonMesh dentedBall(const Vec3& toward) {
  PolygonMesh mesh = uvSphere(64, 40);
  const Vec3 aside = std::abs(toward[0]) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  const Vec3 across = cross(toward, aside);
  for (const double turn : {0.0, 1.25, 2.5, 3.75, 5.0}) {
    const Vec3 other = cross(toward, across);
    Vec3 at{};
    for (std::size_t d = 0; d < 3; ++d)
      at[d] = toward[d] + 0.7 * (std::cos(turn) * across[d] + std::sin(turn) * other[d]);
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
      double* const p = &mesh.positions[i];
      const double angle = angleBetween({p[0], p[1], p[2]}, at);
      const double deep = 0.35 * std::exp(-angle * angle / 0.04);
      for (std::size_t d = 0; d < 3; ++d) p[d] *= 1 - deep;
    }
  }
  return mesh;
}

/// The sum of the directions that edges in the front face; zero if there is no front.
Vec3 frontOf(const PolygonMesh& polygons, std::size_t upAxis = 1) {
  const SeamMesh mesh = Cuttable(polygons).seamMesh;
  const IdVector<SurfaceCorner, double> front = findFront(mesh, edgeBends(mesh), upAxis);
  Vec3 sum{};
  for (const SurfaceCorner h : front.ids()) {
    CHECK(front[h] >= 0);
    CHECK(front[h] <= 1);
    if (mesh.twin[h].exists()) CHECK(front[h] == front[mesh.twin[h]]);
    const Vec3 n = unitNormal(mesh.positions, verticesOf(mesh.vertexOfCorner, triangleOf(h)));
    for (std::size_t d = 0; d < 3; ++d) sum[d] += front[h] * mesh.area[triangleOf(h)] * n[d];
  }
  return sum;
}

}  // namespace

TEST_CASE("the front is where most hollows are", "[seams]") {
  for (const Vec3 toward : {Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0.6, 0, 0.8}}) {
    const Vec3 found = frontOf(dentedBall(toward));
    REQUIRE(norm(found) > 0);
    CHECK(angleBetween(found, toward) < 0.3);
  }
}

TEST_CASE("nobody looks up or down at a front", "[seams]") {
  CHECK(norm(frontOf(dentedBall({0, 1, 0}))) == 0);
  CHECK(norm(frontOf(dentedBall({0, -1, 0}))) == 0);
  CHECK(norm(frontOf(dentedBall({0, 0, 1}), 2)) == 0);
  const Vec3 found = frontOf(dentedBall({0, 1, 0}), 2);
  REQUIRE(norm(found) > 0);
  CHECK(angleBetween(found, {0, 1, 0}) < 0.3);
}

TEST_CASE("balls, boxes and tubes have no front", "[seams]") {
  CHECK(norm(frontOf(uvSphere(32, 16))) == 0);
  CHECK(norm(frontOf(cylinder(32, 8))) == 0);
  CHECK(norm(frontOf(torus(32, 16))) == 0);
}

TEST_CASE("seams in the front are three times as dear", "[seams]") {
  const PolygonMesh ball = dentedBall({1, 0, 0});
  const SeamMesh mesh = Cuttable(ball).seamMesh;
  REQUIRE(mesh.dearness.size() == mesh.twin.size());
  const auto [least, most] = std::minmax_element(mesh.dearness.begin(), mesh.dearness.end());
  CHECK(*least == 1);
  CHECK(*most == kDearInFront);
  CHECK(shareInFront(mesh) > 0.1);
  CHECK(shareInFront(mesh) < 0.5);
  const SeamMesh other = Cuttable(ball, SeamCosts::Length).seamMesh;
  CHECK(other.dearness.empty());
  CHECK(shareInFront(other) == 0);
}
