#include "cut/front.h"

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "cut/edge_bends.h"
#include "cut/normals_around.h"
#include "mesh/triangle_geometry.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

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

TEST_CASE("a figure on its back looks up", "[seams]") {
  const Vec3 lying = frontOf(dentedBall({0, 0.9, 0.436}));
  REQUIRE(norm(lying) > 0);
  CHECK(angleBetween(lying, {0, 1, 0}) < 0.5);
  const Vec3 bowed = frontOf(dentedBall({0, 0.6, 0.8}));
  REQUIRE(norm(bowed) > 0);
  CHECK(angleBetween(bowed, {0, 0, 1}) < 0.8);
}

TEST_CASE("the sides of a nose face where the face does", "[seams]") {
  PolygonMesh mesh = bumpyGrid(40, 40, 0, 1);
  const SeamMesh flat = Cuttable(mesh).seamMesh;
  const auto height = [&](double x, double y) {
    return 0.08 * std::exp(-(x * x + y * y) / (2 * 0.03 * 0.03));
  };
  double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (i % 3 < 2) {
      low[i % 3] = std::min(low[i % 3], mesh.positions[i]);
      high[i % 3] = std::max(high[i % 3], mesh.positions[i]);
    }
  const double side = high[0] - low[0];
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    const double x = (mesh.positions[i] - (low[0] + high[0]) / 2) / side;
    const double y = (mesh.positions[i + 1] - (low[1] + high[1]) / 2) / side;
    mesh.positions[i + 2] = side * height(x, y);
  }
  const SeamMesh nose = Cuttable(mesh).seamMesh;
  const NormalsAround around(nose);
  const Vec3 up = unitNormal(flat.positions, verticesOf(flat.vertexOfCorner, SurfaceTriangle(0)));
  double steepest = 0, most = 0;
  for (const SurfaceCorner h : nose.corners()) {
    const Vec3 own = unitNormal(nose.positions, verticesOf(nose.vertexOfCorner, triangleOf(h)));
    steepest = std::max(steepest, angleBetween(own, up));
    most = std::max(most, angleBetween(around.at(h), up));
  }
  CHECK(steepest > 0.9);
  CHECK(most < 0.5);
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
