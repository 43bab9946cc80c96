#include "mesh/inside_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "abflat/unwrap.h"
#include "base/point2.h"
#include "catch.h"
#include "exact/orientation.h"
#include "exact/overlap.h"
#include "mesh/corner_table.h"
#include "mesh/triangulate.h"
#include "mesh/welded_mesh.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

using Loop = std::vector<std::uint32_t>;

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// A square with holes that are joined to it, or to each other, by random bridges. An island in a
/// hole is bridged to the hole's rim. All of it is one polygon.
class Bridged {
 public:
  Bridged(unsigned holes, bool hasIsland, unsigned seed) : random_(seed) {
    constexpr double kSize = 12;
    add({{0, 0}, {kSize, 0}, {kSize, kSize}, {0, kSize}});
    polygon_ = rings_.front();
    std::vector<unsigned> cells(9);
    for (unsigned i = 0; i < 9; ++i) cells[i] = i;
    std::shuffle(cells.begin(), cells.end(), random_);
    for (unsigned i = 0; i < holes; ++i) {
      const Point2 at{2 + 4.0 * (cells[i] % 3), 2 + 4.0 * (cells[i] / 3)};
      add(ring(at, 1.5, true));
      if (i == 0 && hasIsland) add(ring(at, 0.3, false));
    }
    for (std::size_t i = 1; i < rings_.size(); ++i) bridge(rings_[i], i != 2 || !hasIsland);
    std::rotate(polygon_.begin(), polygon_.begin() + random_() % polygon_.size(), polygon_.end());
  }

  const Loop& polygon() const { return polygon_; }
  double area() const {
    double sum = 0;
    for (const Loop& ring : rings_)
      for (std::size_t i = 2; i < ring.size(); ++i)
        sum += turn(points_[ring[0]], points_[ring[i - 1]], points_[ring[i]]) / 2;
    return sum;
  }

  /// The polygon in a slanted plane.
  PolygonMesh mesh() const {
    PolygonMesh out;
    for (const Point2& p : points_)
      out.positions.insert(out.positions.end(), {p[0], 0.6 * p[1], 0.8 * p[1]});
    out.faceVertices = polygon_;
    out.faceOffsets = {0, static_cast<std::uint32_t>(polygon_.size())};
    return out;
  }

 private:
  std::vector<Point2> ring(const Point2& at, double size, bool isHole) {
    const auto n = static_cast<unsigned>(3 + random_() % 6);
    std::vector<Point2> out;
    for (unsigned k = 0; k < n; ++k) {
      const double r = size * (0.6 + 0.4 * static_cast<double>(random_() % 100) / 100);
      const double angle = 6.283185307179586 * (isHole ? n - k : k) / n;
      out.push_back({at[0] + r * std::cos(angle), at[1] + r * std::sin(angle)});
    }
    return out;
  }

  void add(const std::vector<Point2>& ring) {
    Loop loop;
    for (const Point2& p : ring) {
      loop.push_back(static_cast<std::uint32_t>(points_.size()));
      points_.push_back(p);
    }
    rings_.push_back(loop);
  }

  bool crosses(std::uint32_t a, std::uint32_t b) const {
    const auto meets = [&](std::uint32_t p, std::uint32_t q) {
      if (p == a || p == b || q == a || q == b) return false;
      return turn(points_[a], points_[b], points_[p]) * turn(points_[a], points_[b], points_[q]) <=
                 0 &&
             turn(points_[p], points_[q], points_[a]) * turn(points_[p], points_[q], points_[b]) <=
                 0;
    };
    const auto meetsRing = [&](const Loop& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i)
        if (meets(ring[i], ring[(i + 1) % ring.size()])) return true;
      return false;
    };
    return meetsRing(polygon_) || std::any_of(rings_.begin(), rings_.end(), meetsRing);
  }

  /// Whether b lies within the angle at the polygon's corner i.
  bool isInside(std::size_t i, std::uint32_t b) const {
    const std::size_t n = polygon_.size();
    const Point2 &at = points_[polygon_[i]], &to = points_[polygon_[(i + 1) % n]],
                 &from = points_[polygon_[(i + n - 1) % n]];
    const bool isLeft = turn(at, to, points_[b]) > 0, isRight = turn(at, from, points_[b]) < 0;
    if (polygon_[(i + 1) % n] == polygon_[(i + n - 1) % n]) return true;
    return turn(at, to, from) > 0 ? isLeft && isRight : isLeft || isRight;
  }

  void bridge(const Loop& ring, bool isHole) {
    for (;;) {
      const std::size_t i = random_() % polygon_.size(), j = random_() % ring.size();
      const std::uint32_t from = polygon_[i];
      if (isInside(i, ring[j]) != isHole || crosses(from, ring[j])) continue;
      Loop way(ring.begin() + static_cast<std::ptrdiff_t>(j), ring.end());
      way.insert(way.end(), ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(j) + 1);
      way.push_back(from);
      polygon_.insert(polygon_.begin() + static_cast<std::ptrdiff_t>(i) + 1, way.begin(),
                      way.end());
      return;
    }
  }

  std::mt19937 random_;
  std::vector<Point2> points_;
  std::vector<Loop> rings_;
  Loop polygon_;
};

/// Checks that the triangles fill the area and do not overlap.
void checkFilled(const PolygonMesh& mesh, double area) {
  const Triangulation t = triangulate(mesh);
  std::vector<double> flat;
  double sum = 0;
  int least = 1;
  for (const SurfaceTriangle f : t.face.ids()) {
    std::array<Point2, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const double* at = &mesh.positions[3 * std::size_t{t.vertex[cornerOf(f, k)]}];
      p[k] = {at[0], at[1] * 0.6 + at[2] * 0.8};
      flat.insert(flat.end(), {p[k][0], p[k][1]});
    }
    least = std::min(least, orientation(p[0].data(), p[1].data(), p[2].data()));
    sum += turn(p[0], p[1], p[2]) / 2;
  }
  CHECK(least > 0);
  CHECK(sum == Approx(area));
  CHECK(!findOverlap(flat));
}

}  // namespace

TEST_CASE("polygons with bridged holes are what they bound", "[polygons]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    const Bridged bridged(1 + seed % 7, false, seed);
    const PolygonMesh mesh = bridged.mesh();
    for (const PolygonMesh& same : {mesh, exploded(mesh)}) {
      const WeldedMesh welded = weld(same);
      REQUIRE(welded.mesh.faceCount() == 1);
      CHECK(welded.mesh.faceVertices.size() == mesh.faceVertices.size());
      CHECK(welded.splitFaces.empty());
      checkFilled(welded.mesh, bridged.area());
      for (const InputCorner c : welded.cornerFor.ids())
        CHECK(welded.inputCorner[welded.cornerFor[c]] == c);
    }
  }
}

TEST_CASE("an island in a hole hangs on the bridge that leads to it", "[polygons]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    const Bridged bridged(1 + seed % 5, true, seed);
    const WeldedMesh welded = weld(bridged.mesh());
    REQUIRE(welded.mesh.faceCount() == 1);
    CHECK(welded.mesh.faceVertices.size() == bridged.polygon().size());
    CHECK(welded.splitFaces == Loop{0});
    checkFilled(welded.mesh, bridged.area());
  }
}

TEST_CASE("a polygon with holes becomes one chart, as large as it is", "[polygons]") {
  for (unsigned seed = 0; seed < 8; ++seed) {
    INFO("seed " << seed);
    const Bridged bridged(1 + seed % 4, false, seed);
    UnwrapOptions options;
    options.resolution = 256;
    options.fillHoles = seed % 2 ? FillHoles::Always : FillHoles::Auto;
    const Result<UnwrapResult> result = unwrap(bridged.mesh(), options);
    REQUIRE(result.ok());
    const UnwrapReport& report = result.value().report;
    CHECK(report.valid);
    REQUIRE(report.charts.size() == 1);
    CHECK(report.charts[0].area == Approx(bridged.area()));
    CHECK(report.charts[0].symmetricDirichlet == Approx(1));
    CHECK(report.repair.splitFaces.empty());
  }
}

TEST_CASE("holes that touch the rim, and each other, are holes", "[polygons]") {
  // A hole that touches a corner of the square, and another that touches a corner of that hole.
  PolygonMesh mesh;
  mesh.positions = {0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0, 2, 1, 0, 1, 2, 0, 3, 2, 0, 2, 3, 0};
  mesh.faceVertices = {0, 1, 2, 3, 0, 5, 7, 6, 5, 4};
  mesh.faceOffsets = {0, 10};
  const WeldedMesh welded = weld(mesh);
  CHECK(welded.splitFaces.empty());
  REQUIRE(welded.mesh.faceCount() == 1);
  double sum = 0;
  const Triangulation t = triangulate(welded.mesh);
  for (const SurfaceTriangle f : t.face.ids()) {
    const auto at = [&](std::size_t k) {
      const double* p = &mesh.positions[3 * std::size_t{t.vertex[cornerOf(f, k)]}];
      return Point2{p[0], p[1]};
    };
    CHECK(turn(at(0), at(1), at(2)) > 0);
    sum += turn(at(0), at(1), at(2)) / 2;
  }
  CHECK(sum == Approx(16 - 1.5 - 1));
}

TEST_CASE("a polygon that crosses itself or winds round twice bounds no inside", "[polygons]") {
  const std::vector<double> p{0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0,
                              1, 1, 0, 3, 1, 0, 3, 3, 0, 1, 3, 0};
  const auto pieces = [&](const Loop& places) { return insideLoops(p, places).loops.size(); };
  CHECK(pieces({0, 1, 2, 3, 0, 4, 5, 6, 7, 4}) == 0);  // its hole is filled twice
  CHECK(pieces({0, 1, 2, 3, 0, 2, 1}) == 1);           // what is not folded back
  CHECK(pieces({0, 1, 3, 2, 0, 4, 7, 6, 5, 4}) == 0);  // a bow tie with a hole
  CHECK(pieces({0, 1, 0, 1, 0, 1, 0, 1}) == 0);
  CHECK(pieces({0, 1, 2, 3, 0, 4, 7, 6, 5, 4}) == 1);
}
