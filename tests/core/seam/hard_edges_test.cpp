#include "seam/hard_edges.h"

#include <cmath>
#include <set>

#include "abflat/unwrap.h"
#include "catch.h"
#include "seam/extract_charts.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

struct Welded {
  PolygonMesh input;
  WeldedMesh welded;
  Surface surface;

  explicit Welded(PolygonMesh mesh)
      : input(std::move(mesh)), welded(weld(input)), surface(buildSurface(welded.mesh)) {}
  SurfaceMap map() const { return {input, welded, surface}; }
};

/// Normals of facets or of vertices, at random per face: what is flat is hard all around.
PolygonMesh withNormals(PolygonMesh mesh, const std::vector<std::uint8_t>& isFlat) {
  mesh.normals = mesh.positions;  // those of a sphere around the origin
  mesh.faceNormals = mesh.faceVertices;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    if (!isFlat[f]) continue;
    for (std::size_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c)
      mesh.faceNormals[c] = kNoNormal;
  }
  return mesh;
}

std::vector<std::uint8_t> everyThird(std::size_t faces) {
  std::vector<std::uint8_t> out(faces);
  for (std::size_t f = 0; f < faces; ++f) out[f] = f % 3 == 0;
  return out;
}

/// The marked edges, by the places of their ends in the unwelded mesh.
std::set<std::array<double, 6>> places(const Welded& mesh, const Seams& seams) {
  std::set<std::array<double, 6>> out;
  for (const SurfaceCorner h : seams.ids()) {
    if (!seams[h]) continue;
    std::array<double, 6> ends;
    for (std::size_t k = 0; k < 2; ++k) {
      const InputVertex v = mesh.map().vertex(k == 0 ? h : nextCorner(h));
      for (std::size_t d = 0; d < 3; ++d)
        ends[3 * k + d] = mesh.input.positions[3 * std::size_t{v} + d];
    }
    out.insert(ends);
  }
  return out;
}

}  // namespace

TEST_CASE("hard edges are those around flat faces", "[hard]") {
  const PolygonMesh plain = uvSphere(16, 12);
  const std::vector<std::uint8_t> isFlat = everyThird(plain.faceCount());
  const Welded mesh(withNormals(plain, isFlat));
  const Seams hard = hardEdges(mesh.map());
  REQUIRE(hard.size() == mesh.surface.table.vertex.size());
  for (const SurfaceCorner h : hard.ids()) {
    const SurfaceCorner twin = mesh.surface.table.twin[h];
    const auto flat = [&](SurfaceCorner c) { return isFlat[mesh.map().face(triangleOf(c))] != 0; };
    const bool isInner = mesh.surface.triangulation.isDiagonal[h] || !twin.exists();
    REQUIRE((hard[h] != 0) == (!isInner && (flat(h) || flat(twin))));
  }
}

TEST_CASE("hard edges are the same however vertices are shared, and normals scaled", "[hard]") {
  const PolygonMesh plain = uvSphere(16, 12);
  const Welded mesh(withNormals(plain, everyThird(plain.faceCount())));
  const auto expected = places(mesh, hardEdges(mesh.map()));
  CHECK(expected.size() > 100);
  PolygonMesh torn = exploded(mesh.input);
  torn.normals = mesh.input.normals;
  torn.faceNormals = mesh.input.faceNormals;
  const Welded apart(torn);
  CHECK(places(apart, hardEdges(apart.map())) == expected);
  for (const double scale : {1e-150, 3.0, 1e200}) {
    PolygonMesh scaled = mesh.input;
    for (double& x : scaled.normals) x *= scale;
    const Welded other(scaled);
    CHECK(places(other, hardEdges(other.map())) == expected);
  }
}

TEST_CASE("normals without a direction count as none", "[hard]") {
  const PolygonMesh plain = uvSphere(16, 12);
  const std::vector<std::uint8_t> none(plain.faceCount(), 0), all(plain.faceCount(), 1);
  const Welded flat(withNormals(plain, all));
  const auto expected = places(flat, hardEdges(flat.map()));
  for (const double x : {0.0, std::nan(""), HUGE_VAL}) {
    PolygonMesh mesh = withNormals(plain, none);
    mesh.normals.assign(mesh.normals.size(), x);
    const Welded other(mesh);
    CHECK(places(other, hardEdges(other.map())) == expected);
  }
}

TEST_CASE("smoothing groups: hard between groups, and between flat faces", "[hard]") {
  PolygonMesh mesh = uvSphere(16, 12);
  mesh.faceSmoothing.assign(mesh.faceCount(), 5);
  CHECK(places(Welded(mesh), hardEdges(Welded(mesh).map())).empty());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    mesh.faceSmoothing[f] = static_cast<std::uint32_t>(f % 3);
  const Welded mixed(mesh);
  const Seams hard = hardEdges(mixed.map());
  const auto group = [&](SurfaceCorner c) {
    return mesh.faceSmoothing[mixed.map().face(triangleOf(c))];
  };
  for (const SurfaceCorner h : hard.ids()) {
    const SurfaceCorner twin = mixed.surface.table.twin[h];
    if (!twin.exists() || mixed.surface.triangulation.isDiagonal[h]) continue;
    REQUIRE((hard[h] != 0) == (group(h) != group(twin) || group(h) == 0));
  }
}

TEST_CASE("a mesh without normals and groups has unknown hard edges", "[hard]") {
  const Welded mesh(uvSphere(16, 12));
  CHECK(hardEdges(mesh.map()).empty());
  UnwrapOptions options;
  options.seams.followsHardEdges = true;
  const Status status = unwrap(mesh.input, options).status();
  CHECK(status.code == StatusCode::InvalidOption);
  CHECK(status.message.find("sharp=30") != std::string::npos);
}

TEST_CASE("the seam finder is told which edges are hard", "[hard]") {
  const PolygonMesh plain = uvSphere(16, 12);
  const Welded mesh(withNormals(plain, everyThird(plain.faceCount())));
  const Seams hard = hardEdges(mesh.map());
  const auto meshWith = [&](const Seams& breaks) {
    return makeSeamMesh(mesh.welded.mesh.positions, mesh.surface.table, mesh.surface.fans,
                        mesh.surface.triangulation.isDiagonal, {}, breaks);
  };
  const SeamMesh whole = meshWith(hard), without = meshWith({});
  std::size_t cheaper = 0;
  for (const SurfaceCorner h : whole.corners()) {
    REQUIRE(whole.cost[h] <= without.cost[h]);
    if (whole.cost[h] == without.cost[h]) continue;
    REQUIRE(hard[h]);
    ++cheaper;
  }
  REQUIRE(cheaper > 50);
  const CutSurface cut = cutAlong(whole, hard);
  REQUIRE(cut.charts.size() > 2);
  IdVector<CutChartId, std::uint8_t> isWanted(cut.charts.size(), 0);
  for (const CutChartId c : isWanted.ids()) isWanted[c] = std::uint32_t{c} % 2 == 0;
  const SeamPart part = extractCharts(whole, cut, isWanted);
  for (const SurfaceCorner h : part.mesh.corners())
    REQUIRE(part.mesh.cost[h] == whole.cost[part.wholeHalfEdge[h]]);
}

TEST_CASE("seams prefer to run where the material changes", "[hard]") {
  // Two colours, each half of the way around the tube; the border is on its top and its bottom.
  const unsigned columns = 36, rows = 24;
  PolygonMesh mesh = torus(columns, rows);
  std::set<std::uint32_t> border;
  for (unsigned i = 0; i < columns; ++i) border.insert({6 * columns + i, 18 * columns + i});
  const auto seamsOnBorder = [&](const PolygonMesh& m) {
    UnwrapOptions options;
    options.minUtilization = 0;
    const UnwrapResult r = unwrapped(m, options);
    std::size_t on = 0;
    for (const EdgeVertices& e : r.seams) on += border.count(e[0]) && border.count(e[1]);
    return on;
  };
  CHECK(seamsOnBorder(mesh) < columns / 3);
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const std::size_t row = f / 2 / columns;
    mesh.faceMaterials.push_back(row >= 6 && row < 18);
  }
  // All the way around the hole at least once.
  CHECK(seamsOnBorder(mesh) >= columns);
}

TEST_CASE("where the material does not change, materials change nothing", "[hard]") {
  PolygonMesh mesh = torus(24, 16);
  const UnwrapResult without = unwrapped(mesh, {});
  mesh.faceMaterials.assign(mesh.faceCount(), 0);
  const UnwrapResult with = unwrapped(mesh, {});
  CHECK(with.uv == without.uv);
  CHECK(with.seams == without.seams);
}
