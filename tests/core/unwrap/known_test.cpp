#include <algorithm>
#include <cmath>
#include <tuple>

#include "abflat/unwrap.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Eight charts: seams around the tube and along it.
std::vector<EdgeVertices> torusSeams(unsigned columns, unsigned rows) {
  std::vector<EdgeVertices> out;
  const auto at = [&](unsigned i, unsigned j) { return j % rows * columns + i % columns; };
  for (unsigned j = 0; j < rows; ++j)
    for (unsigned i = 0; i < columns; i += columns / 4) out.push_back({at(i, j), at(i, j + 1)});
  for (unsigned i = 0; i < columns; ++i)
    for (unsigned j = 0; j < rows; j += rows / 2) out.push_back({at(i, j), at(i + 1, j)});
  return out;
}

UnwrapOptions alongSeams(std::vector<EdgeVertices> edges) {
  UnwrapOptions out;
  out.seams.isAuto = false;
  out.seams.edges = std::move(edges);
  return out;
}

std::size_t known(const UnwrapResult& r) {
  return static_cast<std::size_t>(
      std::count_if(r.report.charts.begin(), r.report.charts.end(),
                    [](const UnwrapChart& c) { return c.solver == Solver::Known; }));
}

void checkSameLayout(const UnwrapResult& a, const UnwrapResult& b) {
  CHECK(a.unpacked == b.unpacked);
  CHECK(a.uv == b.uv);
  CHECK(a.cornerUv == b.cornerUv);
  CHECK(a.report.angularDistortion == b.report.angularDistortion);
  CHECK(a.report.quasiConformalMean == b.report.quasiConformalMean);
  CHECK(a.report.symmetricDirichlet == b.report.symmetricDirichlet);
}

}  // namespace

TEST_CASE("what is known is taken over and gives the bytes of solving", "[known]") {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const PolygonMesh mesh = transformed(torus(24, 16), scale, {0, 0, 0});
    UnwrapOptions options = alongSeams(torusSeams(24, 16));
    const UnwrapResult first = unwrapped(mesh, options);
    REQUIRE(first.report.charts.size() == 8);
    CHECK(known(first) == 0);
    options.reuse.known = knownLayout(first);
    const UnwrapResult second = unwrapped(mesh, options);
    CHECK(known(second) == 8);
    checkSameLayout(first, second);
    options.precision = Precision::Single;
    options.reuse.known = knownLayout(unwrapped(mesh, options));
    CHECK(options.reuse.known.unpacked == knownLayout(first).unpacked);
  }
}

TEST_CASE("only charts whose outline changes are solved", "[known]") {
  const PolygonMesh mesh = torus(24, 16);
  const std::vector<EdgeVertices> edges = torusSeams(24, 16);
  const UnwrapResult before = unwrapped(mesh, alongSeams(edges));
  /// Applies the edit, and undoes it again.
  const auto checkEdit = [&](const std::vector<EdgeVertices>& edited, std::size_t charts,
                             std::size_t kept, std::size_t keptBack) {
    UnwrapOptions options = alongSeams(edited);
    const UnwrapResult solved = unwrapped(mesh, options);
    options.reuse.known = knownLayout(before);
    const UnwrapResult quick = unwrapped(mesh, options);
    CHECK(solved.report.charts.size() == charts);
    CHECK(known(quick) == kept);
    checkSameLayout(solved, quick);
    options.seams.edges = edges;
    options.reuse.known = knownLayout(quick);
    const UnwrapResult back = unwrapped(mesh, options);
    CHECK(known(back) == keptBack);
    checkSameLayout(before, back);
  };
  std::vector<EdgeVertices> edited = edges;
  SECTION("a slit keeps the triangles and changes the outline") {
    edited.insert(edited.end(), {{3, 27}, {27, 51}});
    checkEdit(edited, 8, 7, 7);
  }
  SECTION("a chart is cut in two") {
    for (unsigned j = 0; j < 8; ++j) edited.push_back({j * 24 + 3, (j + 1) * 24 + 3});
    checkEdit(edited, 9, 7, 7);
  }
  SECTION("two charts are joined") {
    edited.erase(std::remove_if(edited.begin(), edited.end(),
                                [](const EdgeVertices& e) {
                                  return e[0] % 24 == 6 && e[1] % 24 == 6 && e[0] / 24 < 8;
                                }),
                 edited.end());
    checkEdit(edited, 7, 6, 6);
  }
}

TEST_CASE("with straight seams charts whose seams end elsewhere are solved as well", "[known]") {
  const PolygonMesh mesh = torus(24, 16);
  const std::vector<EdgeVertices> edges = torusSeams(24, 16);
  UnwrapOptions options = alongSeams(edges);
  options.straightSeams = true;
  const UnwrapResult before = unwrapped(mesh, options);
  options.reuse.known = knownLayout(before);
  const UnwrapResult again = unwrapped(mesh, options);
  CHECK(known(again) == 8);
  checkSameLayout(before, again);
  for (std::size_t i = 0; i < 8; ++i) {
    REQUIRE(again.report.charts[i].straight);
    const StraightReport &a = *before.report.charts[i].straight,
                         &b = *again.report.charts[i].straight;
    CHECK(a.runs > 0);
    CHECK(a.vertices > 0);
    CHECK(std::tie(a.runs, a.vertices, a.released, a.deviation) ==
          std::tie(b.runs, b.vertices, b.released, b.deviation));
  }
  const auto checkEdit = [&](const std::vector<EdgeVertices>& more, std::size_t kept) {
    UnwrapOptions edit = options;
    edit.reuse.known = {};
    edit.seams.edges.insert(edit.seams.edges.end(), more.begin(), more.end());
    const UnwrapResult solved = unwrapped(mesh, edit);
    edit.reuse.known = knownLayout(before);
    const UnwrapResult quick = unwrapped(mesh, edit);
    CHECK(known(quick) == kept);
    checkSameLayout(solved, quick);
    options.reuse.known = knownLayout(quick);
    const UnwrapResult back = unwrapped(mesh, options);
    CHECK(known(back) == kept);
    checkSameLayout(before, back);
  };
  SECTION("a slit from the middle of a seam ends it for the chart behind, too") {
    checkEdit({{3, 27}, {27, 51}}, 6);
  }
  SECTION("a slit from a junction is no end for others") { checkEdit({{0, 25}, {25, 50}}, 7); }
  SECTION("a chart is cut in two: one that lies behind both ends of the cut is solved, too") {
    std::vector<EdgeVertices> across;
    for (unsigned j = 0; j < 8; ++j) across.push_back({j * 24 + 3, (j + 1) * 24 + 3});
    checkEdit(across, 6);
  }
  SECTION("with seams that are not straight nothing is known") {
    options.straightSeams = false;
    CHECK(known(unwrapped(mesh, options)) == 0);
  }
}

TEST_CASE("straight seams after other automatic ones are those that solving gives",
          "[known][quality]") {
  std::vector<PolygonMesh> meshes = {torus(24, 16), cylinder(20, 14), bumpyGrid(24, 20, 0.9, 3)};
  for (const char* file : {"spot-uv.obj", "beetle-nonmanifold.obj", "teapot-5parts.obj"})
    if (PolygonMesh mesh = sharedMesh(file); mesh.faceCount() > 0) meshes.push_back(mesh);
  std::size_t taken = 0;
  for (const PolygonMesh& mesh : meshes) {
    UnwrapOptions options, quick;
    options.straightSeams = quick.straightSeams = true;
    for (const double stretch : {1.1, 1.04, 1.05}) {
      options.maxStretch = quick.maxStretch = stretch;
      const Result<UnwrapResult> solved = unwrap(mesh, options), fast = unwrap(mesh, quick);
      REQUIRE(solved.ok());
      REQUIRE(fast.ok());
      checkSameLayout(solved.value(), fast.value());
      taken += known(fast.value());
      quick.reuse.known = knownLayout(fast.value());
    }
  }
  CHECK(taken > 0);
}

TEST_CASE("what cannot be taken over is solved", "[known]") {
  const PolygonMesh mesh = torus(24, 16);
  UnwrapOptions options = alongSeams(torusSeams(24, 16));
  const UnwrapResult first = unwrapped(mesh, options);
  const KnownLayout good = knownLayout(first);
  SECTION("other angles are wanted") {
    options.reuse.known = good;
    options.t = 1;
    CHECK(known(unwrapped(mesh, options)) == 0);
  }
  SECTION("a layout that is not valid") {
    options.reuse.known = good;
    for (std::size_t i = 0; i < options.reuse.known.unpacked.size(); i += 2)
      options.reuse.known.unpacked[i] = -options.reuse.known.unpacked[i];
    const UnwrapResult again = unwrapped(mesh, options);
    CHECK(known(again) == 0);
    checkSameLayout(first, again);
  }
  SECTION("no numbers") {
    options.reuse.known = good;
    options.reuse.known.unpacked[2 * options.reuse.known.triangles[0]] = NAN;
    CHECK(known(unwrapped(mesh, options)) == 7);
  }
}

TEST_CASE("polygons, faces without area and places that occur twice are known, too", "[known]") {
  PolygonMesh mesh = torus(12, 8);
  std::vector<std::uint32_t> faces(mesh.faceVertices);
  faces.insert(faces.begin() + 30, {faces[0], faces[1], faces[1]});
  faces.insert(faces.end(), {faces[0], faces[1], faces[2]});
  PolygonMesh soup;
  for (std::size_t c = 0; c < faces.size(); ++c)
    for (std::size_t d = 0; d < 3; ++d) soup.positions.push_back(mesh.positions[3 * faces[c] + d]);
  std::vector<std::uint32_t> corners(faces.size());
  for (std::uint32_t c = 0; c < corners.size(); ++c) corners[c] = c;
  soup = makeTriangleMesh(soup.positions, corners);
  for (const PolygonMesh& m : {makeTriangleMesh(mesh.positions, faces), soup, star(7)}) {
    UnwrapOptions options;
    options.minUtilization = 0;  // charts cut by packing are flattened again
    const UnwrapResult first = unwrapped(m, options);
    options.reuse.known = knownLayout(first);
    const UnwrapResult second = unwrapped(m, options);
    CHECK(known(second) == first.report.charts.size());
    checkSameLayout(first, second);
  }
}

TEST_CASE("what is known of another mesh is refused", "[known]") {
  UnwrapOptions options;
  const PolygonMesh mesh = torus(12, 8);
  const auto refused = [&](const KnownLayout& layout) {
    options.reuse.known = layout;
    const Status s = unwrap(mesh, options).status();
    return s.code == StatusCode::InvalidOption &&
           s.message.find("the known layout belongs to another mesh") == 0;
  };
  const KnownLayout good = knownLayout(unwrapped(mesh, {}));
  CHECK_FALSE(refused(good));
  CHECK(refused(knownLayout(unwrapped(torus(12, 9), {}))));
  CHECK(refused(knownLayout(unwrapped(torus(8, 12), {}))));
  const auto changed = [&](auto change) {
    KnownLayout bad = good;
    change(bad);
    return bad;
  };
  CHECK(refused(changed([](KnownLayout& l) { l.unpacked.pop_back(); })));
  CHECK(refused(changed([](KnownLayout& l) { l.chartOfTriangle.pop_back(); })));
  CHECK(refused(changed([](KnownLayout& l) { l.chartOfTriangle[5] = 0xfffffff0u; })));
  CHECK(refused(changed([](KnownLayout& l) { l.triangles[7] = 0xfffffff0u; })));
  CHECK(refused(changed([](KnownLayout& l) { l.vertexMap[3] = 0; })));
}
