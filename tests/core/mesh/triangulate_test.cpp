#include "mesh/triangulate.h"

#include <cmath>
#include <random>

#include "catch.h"
#include "mesh/corner_table.h"
#include "support/instrumented.h"

using namespace abflat;
using abflat::test::cases;

namespace {

/// One face around the origin, with its corners at these distances from it.
PolygonMesh starPolygon(const std::vector<double>& radius) {
  PolygonMesh mesh;
  for (std::size_t k = 0; k < radius.size(); ++k) {
    const double angle =
        6.283185307179586 * static_cast<double>(k) / static_cast<double>(radius.size());
    for (const double x : {radius[k] * std::cos(angle), radius[k] * std::sin(angle), 0.0})
      mesh.positions.push_back(x);
    mesh.faceVertices.push_back(static_cast<std::uint32_t>(k));
  }
  mesh.faceOffsets = {0, static_cast<std::uint32_t>(radius.size())};
  return mesh;
}

double doubleArea(const PolygonMesh& mesh, const std::uint32_t* v, std::size_t count) {
  double sum = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double *a = &mesh.positions[3 * v[k]], *b = &mesh.positions[3 * v[(k + 1) % count]];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

/// Checks that triangles have positive area and fill the face, and that diagonals have two sides.
void checkTriangulated(const PolygonMesh& mesh) {
  const std::size_t n = mesh.faceVertices.size();
  const Triangulation t = triangulate(mesh);
  REQUIRE(t.face.size() == n - 2);
  double sum = 0, least = 1;
  for (const SurfaceTriangle f : t.face.ids()) {
    const double area = doubleArea(mesh, verticesOf(t.vertex, f).data(), 3);
    sum += area;
    least = std::min(least, area);
  }
  CHECK(least > 0);
  CHECK(sum == Approx(doubleArea(mesh, mesh.faceVertices.data(), n)));
  const CornerTable table = buildCornerTable(t, n);
  std::size_t sides = 0, wrong = 0;
  for (const SurfaceCorner h : table.corners()) {
    const SurfaceCorner g = table.twin[h];
    if (!g.exists()) {
      ++sides;
      wrong += t.isDiagonal[h];
    } else {
      wrong += !t.isDiagonal[h] || table.twin[g] != h || t.corner[g] != t.corner[nextCorner(h)];
    }
  }
  CHECK(sides == n);
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("polygons are filled with triangles, whatever their shape") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> distance(0.3, 1);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> radius(4 + random() % 100);
    for (double& r : radius) r = distance(random);
    checkTriangulated(starPolygon(radius));
  }
}

TEST_CASE("faces of thousands of corners are no trouble") {
  std::vector<double> radius(6000, 1.0);
  checkTriangulated(starPolygon(radius));
  for (std::size_t k = 0; k < radius.size(); k += 2)
    radius[k] = 0.5 + 0.3 * std::sin(static_cast<double>(k));
  checkTriangulated(starPolygon(radius));
  // A hundred thousand corners: every second one reflex, or nearly all of them on four lines.
  const std::size_t side = cases(25000u, 2500u);
  radius.assign(4 * side, 1.0);
  for (std::size_t k = 0; k < radius.size(); k += 2) radius[k] = 0.9;
  checkTriangulated(starPolygon(radius));
  PolygonMesh square = starPolygon(std::vector<double>(4 * side, 1.0));
  for (std::size_t k = 0; k < 4 * side; ++k) {
    const double along = static_cast<double>(k % side) / static_cast<double>(side);
    const double x[] = {along, 1, 1 - along, 0}, y[] = {0, along, 1, 1 - along};
    square.positions[3 * k] = x[k / side];
    square.positions[3 * k + 1] = y[k / side];
  }
  checkTriangulated(square);
}

TEST_CASE("the roundest ear is cut off first") {
  PolygonMesh mesh;
  mesh.positions = {0, 0, 0, 4, 0, 0, 5, 1, 0, 4, 2, 0, 2, 2.5, 0};
  mesh.faceVertices = {0, 1, 2, 3, 4};
  mesh.faceOffsets = {0, 5};
  // Area over squared sides: 10 / 36.5 at corner 0, 2 / 8 at corner 2, less at the others.
  const auto corner = triangulate(mesh).corner;
  CHECK(std::vector<std::uint32_t>(corner.begin(), corner.end()) ==
        std::vector<std::uint32_t>{4, 0, 1, 1, 2, 3, 1, 3, 4});
}
