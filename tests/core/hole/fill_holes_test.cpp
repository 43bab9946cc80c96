#include "hole/fill_holes.h"

#include "base/constants.h"
#include "catch.h"
#include "chart/chart_set.h"
#include "seam/path_forest.h"
#include "support/cut_meshes.h"
#include "support/holes.h"
#include "support/instrumented.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

struct Filled {
  explicit Filled(PolygonMesh polygons, FillHoles mode = FillHoles::Auto)
      : cuttable(std::move(polygons)), mesh(cuttable.seamMesh) {
    fillHoles(mode, {}, mesh);
  }

  Seams find(bool isAuto, FillHoles mode, SeamReport* report = nullptr) const {
    SeamOptions options;
    options.isAuto = isAuto;
    options.fillHoles = mode;
    return findSeams(mesh, {}, options, report);
  }
  ChartSet charts(const Seams& seams) const {
    return makeCharts(cuttable.mesh, filledTable(mesh, cuttable.surface.fans.inputVertex, seams));
  }

  Cuttable cuttable;
  SeamMesh mesh;
};

std::uint32_t holesIn(const SeamMesh& mesh) {
  return mesh.hole.empty() || !mesh.hole.back().exists() ? 0 : mesh.hole.back() + 1;
}

std::uint32_t holesIn(const ChartSet& set) {
  std::uint32_t sum = 0;
  for (const ChartId i : set.ids()) sum += set.topology(i).filledHoles;
  return sum;
}

/// Whether it has Euler characteristic 1 and one loop, judged by connectivity alone.
bool isDisk(const DiskChart& chart) {
  std::size_t edges = 0, open = 0;
  for (const ChartCorner h : chart.corners()) {
    const bool isOpen = !chart.twin[h].exists();
    open += isOpen;
    edges += isOpen || h < chart.twin[h];
  }
  return open == chart.boundary.size() && chart.vertexCount() + chart.triangleCount() == edges + 1;
}

}  // namespace

TEST_CASE("filling leaves the surface as it is and one loop to each chart", "[holes]") {
  const Filled filled(windowed(bumpyGrid(27, 18, 0.3, 4), 27, 9, 3));
  const SeamMesh &mesh = filled.mesh, &surface = filled.cuttable.seamMesh;
  CHECK(holesIn(mesh) == 6);
  CHECK(mesh.totalArea() == surface.totalArea());
  for (const SurfaceCorner h : surface.corners()) {
    CHECK(mesh.vertexOfCorner[h] == surface.vertexOfCorner[h]);
    if (surface.twin[h].exists()) CHECK(mesh.twin[h] == surface.twin[h]);
  }
  for (const SurfaceCorner h : mesh.corners()) {
    const SurfaceCorner o = mesh.twin[h];
    if (!o.exists()) continue;
    CHECK(mesh.twin[o] == h);
    CHECK(mesh.vertexOfCorner[o] == mesh.head(h));
    CHECK(mesh.head(o) == mesh.vertexOfCorner[h]);
  }
  const CutSurface s = cutAlong(mesh, Seams(mesh.twin.size(), 0));
  REQUIRE(s.charts.size() == 1);
  CHECK(s.charts.front().isDisk());
  // Gauss and Bonnet: the curvature of the filling is exactly the turning that was missing.
  double curvature = 0;
  for (const OpenVertex v : s.vertices())
    curvature += (s.isBoundary[v] ? kPi : 2 * kPi) - mesh.angleSum[s.meshVertex[v]];
  CHECK(curvature == Approx(2 * kPi));
}

TEST_CASE("a sheet with windows takes no seam, a tube none for a small hole", "[holes]") {
  SeamReport report;
  const Filled sheet(windowed(bumpyGrid(36, 18, 0.1, 4), 36, 9, 5));
  ChartSet set = sheet.charts(sheet.find(true, FillHoles::Auto, &report));
  CHECK(report.seamLength == 0);
  CHECK(report.charts == 1);
  CHECK(holesIn(set) == 8);

  const PolygonMesh tube = cylinder(60, 21);
  const Filled pierced(punched(tube, [](std::uint32_t f) {
    const std::uint32_t column = f / 2 % 60, row = f / 2 / 60;
    return column >= 30 && column < 32 && row >= 10 && row < 12;
  }));
  SeamReport uncut;
  findSeams(Cuttable(tube).seamMesh, {}, {}, &uncut);
  set = pierced.charts(pierced.find(true, FillHoles::Auto, &report));
  CHECK(report.charts == 1);
  CHECK(report.seamLength < 1.05 * uncut.seamLength);
  // Without automatic seams the ends are joined as well, since the tube would be stretched.
  set = pierced.charts(pierced.find(false, FillHoles::Auto, &report));
  CHECK(report.charts == 1);
  CHECK(report.seamLength < 1.05 * uncut.seamLength);
  CHECK(report.seamLength > 0);
}

TEST_CASE("holes are never or always filled where that is asked for", "[holes]") {
  const PolygonMesh mesh = windowed(bumpyGrid(18, 18, 0.1, 4), 18, 9, 3);
  const Filled open(mesh, FillHoles::Never), closed(cylinder(24, 10), FillHoles::Always);
  CHECK(open.mesh.hole.empty());
  SeamReport report;
  open.find(false, FillHoles::Never, &report);
  CHECK(report.seamLength > 0);
  for (const bool isAuto : {false, true}) {
    const Seams seams = closed.find(isAuto, FillHoles::Always, &report);
    CHECK(holesIn(closed.charts(seams)) == 1);
  }
}

TEST_CASE("motheaten surfaces fall into disks, their holes filled or not", "[holes]") {
  std::size_t all = 0, kept = 0;
  for (unsigned seed = 0; seed < cases(30u, 9u); ++seed)
    for (const PolygonMesh& whole : {torus(30, 20), bumpyGrid(20, 20, 0.5, seed), cylinder(30, 15)})
      for (const FillHoles mode : {FillHoles::Never, FillHoles::Auto, FillHoles::Always}) {
        INFO("seed " << seed << ", mode " << nameOf(mode));
        const Filled filled(motheaten(whole, seed % 2 ? 8 : 40, seed), mode);
        const Seams seams = filled.find(seed % 3 > 0, mode);
        const ChartSet set = filled.charts(seams);
        std::size_t triangles = 0;
        bool areDisks = true;
        for (const ChartId i : set.ids()) {
          const DiskChart chart = set.chart(i);
          const std::size_t own = set.topology(i).triangles.size();
          areDisks = areDisks && isDisk(chart);
          triangles += own;
          CHECK(own == chart.surfaceTriangles().size());
          CHECK(own > 0);
        }
        CHECK(areDisks);
        CHECK(triangles == filled.cuttable.surface.table.triangles().size());
        CHECK(set.ofTriangle.size() == triangles);
        all += holesIn(filled.mesh);
        kept += holesIn(set);
        if (mode == FillHoles::Never) CHECK(holesIn(set) == 0);
      }
  CHECK(all > cases(1000u, 300u));
  CHECK(kept > all / 4);
}

TEST_CASE("where holes touch, each is filled by itself or none is", "[holes]") {
  // Two holes that share a corner, and one at a corner of the boundary.
  const Filled filled(punched(bumpyGrid(8, 8, 0.1, 3), [](std::uint32_t f) {
    const std::uint32_t square = f / 2;
    return square == 2 * 8 + 2 || square == 3 * 8 + 3 || square == 6 * 8 + 6 || square == 7 * 8 + 7;
  }));
  const ChartSet set = filled.charts(filled.find(true, FillHoles::Auto));
  REQUIRE(set.size() > 0);
  for (const ChartId i : set.ids()) CHECK(isDisk(set.chart(i)));
}

TEST_CASE("holes that stay filled leave no vertex without a path, and no walk without an end",
          "[holes]") {
  // Only edges lie between the holes: many vertices have nothing but rims.
  const auto checkered = [](unsigned columns, unsigned rows, unsigned seed) {
    std::mt19937 random(seed);
    return punched(bumpyGrid(columns, rows, 1.5, seed), [&, columns, rows](std::uint32_t f) {
      const unsigned column = f / 2 % columns, row = f / 2 / columns;
      const bool isInside =
          column > 0 && column + 1 < columns && row > 0 && row + 1 < rows && random() % 8 > 0;
      return isInside && (seed % 2 ? f % 2 == 1 : (column + row) % 2 == 0);
    });
  };
  for (unsigned seed = 0; seed < 24; ++seed) {
    INFO("seed " << seed);
    const Filled filled(checkered(7 + seed % 5, 6, seed), FillHoles::Always);
    const CutSurface s = cutAlong(filled.mesh, Seams(filled.mesh.twin.size(), 0));
    std::vector<OpenVertex> extra;
    for (const CutSurface::Chart& c : s.charts)
      if (c.loops == 0) extra.push_back(s.tail(cornerOf(c.firstTriangle, 0)));
    const PathForest forest = findPaths(filled.mesh, s, extra);
    for (const OpenVertex v : s.vertices()) CHECK(forest.source[v].exists());
    const Seams seams = filled.find(true, FillHoles::Always);
    const ChartSet set = filled.charts(seams);
    for (const ChartId i : set.ids()) CHECK(isDisk(set.chart(i)));
  }
}
