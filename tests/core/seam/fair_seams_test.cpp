#include "seam/fair_seams.h"

#include <array>
#include <cmath>

#include "abflat/unwrap.h"
#include "catch.h"
#include "seam/fair_paths.h"
#include "seam/occlusion.h"
#include "seam/prediction.h"
#include "support/cut_meshes.h"
#include "support/isosurface.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

constexpr unsigned kSide = 21;

/// A sheet of squares with given heights, in units of their side length.
template <typename Height>
PolygonMesh sheet(Height height) {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;
  for (unsigned j = 0; j < kSide; ++j)
    for (unsigned i = 0; i < kSide; ++i)
      positions.insert(positions.end(), {1.0 * i, 1.0 * j, height(1.0 * i, 1.0 * j)});
  for (unsigned j = 0; j + 1 < kSide; ++j)
    for (unsigned i = 0; i + 1 < kSide; ++i) {
      const std::uint32_t a = j * kSide + i, b = a + kSide;
      triangles.insert(triangles.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  return makeTriangleMesh(std::move(positions), std::move(triangles));
}

/// Marks the edges between consecutive places in the list, and returns them in order.
std::vector<SurfaceCorner> markedPath(const SeamMesh& mesh,
                                      const std::vector<std::array<unsigned, 2>>& places,
                                      Seams& seams) {
  std::vector<SurfaceCorner> out;
  for (std::size_t k = 0; k + 1 < places.size(); ++k)
    for (const SurfaceCorner h : mesh.corners())
      if (mesh.vertexOfCorner[h] == places[k][1] * kSide + places[k][0] &&
          mesh.head(h) == places[k + 1][1] * kSide + places[k + 1][0]) {
        out.push_back(h);
        seams[h] = seams[mesh.twin[h]] = 1;
      }
  return out;
}

double costOf(const IdVector<SurfaceCorner, double>& cost, const Seams& seams) {
  double out = 0;
  for (const SurfaceCorner h : seams.ids())
    if (seams[h]) out += cost[h] / 2;
  return out;
}

IdVector<SurfaceCorner, float> everywhere(const Seams& seams, float width) {
  return IdVector<SurfaceCorner, float>(seams.size(), width);
}

/// From the lower to the upper border, with a sideways detour in the middle.
std::vector<std::array<unsigned, 2>> detour() {
  std::vector<std::array<unsigned, 2>> out;
  for (unsigned j = 0; j < 7; ++j) out.push_back({10, j});
  for (unsigned k = 0; k < 4; ++k) out.push_back({10 + k, 7 + k});
  for (unsigned k = 0; k < 3; ++k) out.push_back({12 - k, 10});
  for (unsigned j = 11; j < kSide; ++j) out.push_back({10, j});
  return out;
}

}  // namespace

TEST_CASE("a path that goes a detour is drawn straight, and stays where it has no room", "[fair]") {
  const Cuttable c(sheet([](double, double) { return 0.0; }), SeamCosts::Length);
  const SeamMesh& mesh = c.seamMesh;
  Seams before(mesh.twin.size(), 0);
  const std::vector<SurfaceCorner> path = markedPath(mesh, detour(), before);
  REQUIRE(path.size() == detour().size() - 1);
  const double straight = mesh.length[path.front()] * (kSide - 1);
  CHECK(pathCost(mesh, mesh.cost, path) > 1.1 * straight);
  Seams seams = before;
  CHECK_FALSE(fairPaths(mesh, mesh.cost, everywhere(seams, 0), seams));
  CHECK(seams == before);
  CHECK(fairPaths(mesh, mesh.cost, everywhere(seams, 0.2f), seams));
  CHECK(costOf(mesh.cost, seams) == Approx(straight));
  CHECK(chartsOf(c, seams).size() == 2);
}

TEST_CASE("one of two paths as long is taken that turns less", "[fair]") {
  const Cuttable c(sheet([](double, double) { return 0.0; }), SeamCosts::Length);
  const SeamMesh& mesh = c.seamMesh;
  Seams staircase(mesh.twin.size(), 0), seams;
  std::vector<std::array<unsigned, 2>> places;
  for (unsigned k = 2; k < 12; ++k) {
    places.push_back({k, 18 - k});
    places.push_back({k + 1, 18 - k});
  }
  const double before = pathCost(mesh, mesh.cost, markedPath(mesh, places, staircase));
  seams = staircase;
  // Both ends lie inside, so they stay.
  CHECK(fairPaths(mesh, mesh.cost, everywhere(seams, 0.4f), seams));
  CHECK(costOf(mesh.cost, seams) == Approx(costOf(mesh.cost, staircase)));
  CHECK(before > 1.2 * costOf(mesh.cost, seams));
}

TEST_CASE("a crease is taken and not the flat beside it", "[fair]") {
  const Cuttable c(sheet([](double x, double) { return std::abs(x - 11); }));
  const SeamMesh& mesh = c.seamMesh;
  Seams seams(mesh.twin.size(), 0);
  std::vector<std::array<unsigned, 2>> places;
  for (unsigned j = 0; j < kSide; ++j) places.push_back({9, j});
  markedPath(mesh, places, seams);
  CHECK(fairPaths(mesh, mesh.cost, everywhere(seams, 0.3f), seams));
  for (const SurfaceCorner h : seams.ids())
    if (seams[h]) CHECK(mesh.vertexOfCorner[h] % kSide == 11);
}

TEST_CASE("fairing keeps charts and their topology, and lowers what seams cost", "[fair]") {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Cuttable c(seed <= 2 ? isosurface(18, rings(seed)) : isosurface(16, noise(2, seed)),
                     SeamCosts::Length);
    const SeamMesh& mesh = c.seamMesh;
    SeamOptions options;
    options.maxStretch = 1.01;
    options.prices = SeamPrices::none();
    const Seams before = findSeams(mesh, {}, options, nullptr);
    // A noisy cost, so that there is much to redraw.
    IdVector<SurfaceCorner, double> cost = mesh.cost;
    for (const SurfaceCorner h : cost.ids())
      if (h < mesh.twin[h]) cost[h] = cost[mesh.twin[h]] = cost[h] * (1 + h * 7919 % 101 / 50.0);
    for (const float width : {0.05f, 0.2f, 1.0f}) {
      CAPTURE(seed, width);
      Seams seams = before;
      CHECK(fairPaths(mesh, cost, everywhere(seams, width), seams));
      CHECK(costOf(cost, seams) < costOf(cost, before));
      const std::vector<PolygonMesh> charts = chartsOf(c, seams);
      CHECK(charts.size() == chartsOf(c, before).size());
      for (const PolygonMesh& chart : charts) CHECK(inspect(chart).disk.ok());
    }
  }
}

TEST_CASE("seams are drawn anew within the bounds, and those that are given stay", "[fair]") {
  const Cuttable c(isosurface(24, rings(1)));
  const SeamMesh& mesh = c.seamMesh;
  const Seams none(mesh.twin.size(), 0);
  SeamOptions options;
  options.maxStretch = 1.01;
  const Seams found = findSeams(mesh, none, options, nullptr);
  LogScale scale(mesh, nullptr);
  const LogScales before = scale.solve(cutAlong(mesh, found), {});
  for (const double maxStretch : {1.01, 1.02, 1.2}) {
    options.maxStretch = maxStretch;
    Seams seams = found;
    LogScales u = before;
    fairSeams({mesh, none, options, scale, u, seams});
    const CutSurface s = cutAlong(mesh, seams);
    const LogScales own = scale.solve(s, {});
    CHECK(u == own);
    for (const double stretch : predictStretch(mesh, s, own).stretch)
      CHECK(stretch <= maxStretch * (1 + 1e-9));
    Seams kept = found;
    fairSeams({mesh, found, options, scale, u, kept});
    CHECK(kept == found);
  }
}

TEST_CASE("seams of a box follow its edges", "[fair]") {
  constexpr unsigned n = 6;  // squares along a side
  PolygonMesh box;
  box.faceOffsets = {0};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool isFar : {false, true})
      for (unsigned j = 0; j < n; ++j)
        for (unsigned i = 0; i < n; ++i) {
          std::array<std::array<unsigned, 2>, 4> corners{
              {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
          if (!isFar) std::swap(corners[1], corners[3]);
          for (const auto& [a, b] : corners) {
            std::array<double, 3> p{};
            p[axis] = isFar ? n : 0;
            p[(axis + 1) % 3] = a;
            p[(axis + 2) % 3] = b;
            box.faceVertices.push_back(static_cast<std::uint32_t>(box.vertexCount()));
            box.positions.insert(box.positions.end(), p.begin(), p.end());
          }
          box.faceOffsets.push_back(static_cast<std::uint32_t>(box.faceVertices.size()));
        }
  for (const double maxStretch : {1.001, 1.01}) {
    UnwrapOptions options;
    options.maxStretch = maxStretch;
    options.minUtilization = 0;
    const Result<UnwrapResult> result = unwrap(box, options);
    REQUIRE(result.ok());
    CHECK(!result.value().seams.empty());
    for (const EdgeVertices& seam : result.value().seams)
      for (const std::uint32_t v : seam) {
        int sides = 0;
        for (std::size_t d = 0; d < 3; ++d) {
          const double x = box.positions[3 * v + d];
          sides += x == 0 || x == n;
        }
        CHECK(sides >= 2);
      }
  }
}

TEST_CASE("what the surface looks out on is itself in a groove, and nothing on a convex body",
          "[fair]") {
  for (const double hidden : occlusion(Cuttable(isosurface(16, rings(0))).seamMesh))
    CHECK(hidden < 0.02);
  const Cuttable c(sheet([](double x, double) { return 3 * std::abs(x - 10); }));
  const IdVector<SurfaceTriangle, double> hidden = occlusion(c.seamMesh);
  std::array<double, 2> sum{}, count{};  // near the groove, and farther from it
  for (const SurfaceTriangle f : hidden.ids()) {
    CHECK(hidden[f] >= 0);
    CHECK(hidden[f] <= 1);
    const double x = c.mesh.positions[3 * c.mesh.faceVertices[3 * f]];
    const std::size_t isFar = std::abs(x - 10) < 4 ? 0 : 1;
    sum[isFar] += hidden[f];
    ++count[isFar];
  }
  CHECK(sum[0] / count[0] > sum[1] / count[1]);
}
