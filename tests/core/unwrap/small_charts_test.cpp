#include "unwrap/small_charts.h"

#include <algorithm>

#include "catch.h"
#include "support/cut_meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

constexpr unsigned kSide = 60;  ///< squares

PolygonMesh sheet() {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;
  for (unsigned j = 0; j <= kSide; ++j)
    for (unsigned i = 0; i <= kSide; ++i) positions.insert(positions.end(), {1.0 * i, 1.0 * j, 0});
  for (unsigned j = 0; j < kSide; ++j)
    for (unsigned i = 0; i < kSide; ++i) {
      const std::uint32_t a = j * (kSide + 1) + i, above = a + kSide + 1;
      triangles.insert(triangles.end(), {a, a + 1, above + 1, a, above + 1, above});
    }
  return makeTriangleMesh(positions, triangles);
}

/// A sheet of squares that is cut into two or three charts.
struct CutSheet {
  Cuttable c{sheet()};
  OpenSurface open;

  /// `chartOf`: the chart in which a square lies.
  template <class ChartOf>
  explicit CutSheet(ChartOf chartOf) {
    open.mesh = c.seamMesh;
    open.inputVertex = c.surface.fans.inputVertex;
    open.seams = Seams(open.mesh.twin.size(), 0);
    for (const SurfaceCorner h : open.seams.ids()) {
      const SurfaceCorner o = open.mesh.twin[h];
      open.seams[h] = o.exists() && squareOf(h, chartOf) != squareOf(o, chartOf);
    }
  }

  template <class ChartOf>
  static int squareOf(SurfaceCorner h, ChartOf chartOf) {
    const unsigned square = triangleOf(h) / 2;
    return chartOf(square % kSide, square / kSide);
  }

  /// Both sides of the edges between these columns and rows become seams.
  void cutUpTo(unsigned column, unsigned row) {
    const SeamMesh& mesh = open.mesh;
    const auto isOn = [&](SurfaceVertex v) {
      const unsigned input = open.inputVertex[v];
      return input % (kSide + 1) == column && input / (kSide + 1) <= row;
    };
    for (const SurfaceCorner h : open.seams.ids())
      if (mesh.twin[h].exists() && isOn(mesh.tail(h)) && isOn(mesh.head(h))) open.seams[h] = 1;
  }

  LaidCharts laid() const {
    LaidCharts out;
    out.set = makeCharts(c.mesh, filledTable(open.mesh, open.inputVertex, open.seams));
    out.flat.resize(out.set.size());
    return out;
  }

  std::size_t seamEdges() const {
    return static_cast<std::size_t>(std::count(open.seams.begin(), open.seams.end(), 1)) / 2;
  }
};

/// A square in the middle of the sheet, with a cut from the border to its corner.
CutSheet island() {
  CutSheet out([](unsigned i, unsigned j) { return i == 30 && j == 20; });
  out.cutUpTo(30, 20);
  return out;
}

UnwrapOptions options() {
  UnwrapOptions out;
  out.resolution = 64;
  return out;
}

}  // namespace

TEST_CASE("a small chart is joined to the chart around it", "[unwrap]") {
  CutSheet sheet = island();
  const LaidCharts before = sheet.laid();
  REQUIRE(before.set.size() == 2);
  SmallCharts small;
  const Seams seams = small.join(before, options(), sheet.open);
  CHECK(std::count(seams.begin(), seams.end(), 1) == 2 * 24);
  CHECK(sheet.seamEdges() == 20);
  const LaidCharts now = sheet.laid();
  REQUIRE(now.set.size() == 1);
  const IdVector<ChartId, std::uint8_t> refused = small.refused(before, now, options(), {});
  CHECK(std::count(refused.begin(), refused.end(), 0) == 2);
}

TEST_CASE("a union that is bad is taken back and not tried again", "[unwrap]") {
  struct {
    double before, now;
    bool isRefused;
  } const cases[] = {{1, 1, false}, {1, 1.001, true}, {1.001, 1.01, false}, {1.001, 1.05, true}};
  for (const auto& each : cases) {
    CutSheet sheet = island();
    LaidCharts before = sheet.laid();
    SmallCharts small;
    const Seams seams = small.join(before, options(), sheet.open);
    LaidCharts now = sheet.laid();
    for (FlatChart& chart : before.flat) chart.distortion.symmetricDirichlet = each.before;
    now.flat[ChartId(0)].distortion.symmetricDirichlet = each.now;
    const IdVector<ChartId, std::uint8_t> refused = small.refused(before, now, options(), {});
    CHECK(std::count(refused.begin(), refused.end(), 1) == (each.isRefused ? 2 : 0));
    sheet.open.seams = seams;
    CHECK(small.join(before, options(), sheet.open).empty() == each.isRefused);
  }
}

TEST_CASE("what is large, wide and cut off by given seams stays", "[unwrap]") {
  const auto joins = [](CutSheet sheet) {
    return !SmallCharts().join(sheet.laid(), options(), sheet.open).empty();
  };
  // 64 texels for about 77 units: 8 texels are about 10 units.
  CHECK(joins(CutSheet([](unsigned i, unsigned) { return i < 6; })));
  CHECK_FALSE(joins(CutSheet([](unsigned i, unsigned) { return i < 20; })));
  CutSheet given([](unsigned i, unsigned) { return i < 6; });
  given.open.given = given.open.seams;
  CHECK_FALSE(joins(given));
}

TEST_CASE("a chart takes several small ones at first, then one at a time", "[unwrap]") {
  const auto chartOf = [](unsigned i, unsigned j) {
    return j > 0 ? 0 : i < 1 ? 1 : i > 58 ? 2 : 0;
  };
  CutSheet sheet(chartOf);
  const LaidCharts before = sheet.laid();
  REQUIRE(before.set.size() == 3);
  SmallCharts small;
  const Seams seams = small.join(before, options(), sheet.open);
  LaidCharts now = sheet.laid();
  REQUIRE(now.set.size() == 1);
  now.flat[ChartId(0)].problem = "crosses itself";
  const IdVector<ChartId, std::uint8_t> refused = small.refused(before, now, options(), {});
  CHECK(std::count(refused.begin(), refused.end(), 1) == 3);
  sheet.open.seams = seams;
  CHECK_FALSE(small.join(before, options(), sheet.open).empty());
  CHECK(sheet.laid().set.size() == 2);
}
