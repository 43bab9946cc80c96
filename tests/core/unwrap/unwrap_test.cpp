#include "abflat/unwrap.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Cuts a torus of that many vertices into a quarter and the rest, both disks.
SeamSources inTwo(std::uint32_t columns, std::uint32_t rows) {
  SeamSources seams;
  seams.isAuto = false;
  for (std::uint32_t i = 0; i < columns; ++i) seams.edges.push_back({i, (i + 1) % columns});
  for (std::uint32_t j = 0; j < rows; ++j)
    for (const std::uint32_t i : {0u, columns / 4})
      seams.edges.push_back({columns * j + i, columns * ((j + 1) % rows) + i});
  return seams;
}

}  // namespace

TEST_CASE("every corner has a texcoord, and a vertex is repeated along seams only") {
  for (const PolygonMesh& mesh : {tetrahedron(), torus(24, 12), cylinder(12, 6), star(7)}) {
    const Result<UnwrapResult> result = unwrap(mesh, {});
    REQUIRE(result.ok());
    const UnwrapResult& r = result.value();
    CHECK(r.report.valid);
    REQUIRE(r.cornerUv.size() == mesh.faceVertices.size());
    CHECK(std::all_of(r.uv.begin(), r.uv.end(), [](double x) { return x >= 0 && x <= 1; }));
    for (std::size_t c = 0; c < r.cornerUv.size(); ++c) {
      const std::uint32_t vertex = r.cornerVertex[c];
      CHECK(r.vertexMap[vertex] == mesh.faceVertices[c]);
      CHECK(r.vertexUv[vertex] == r.cornerUv[c]);
    }
    CHECK(std::is_sorted(r.vertexMap.begin(), r.vertexMap.end()));
    CHECK(r.vertexMap.size() == r.uv.size() / 2);
    CHECK(r.vertexMap.size() <= mesh.vertexCount() + 2 * r.seams.size());
  }
}

TEST_CASE("the atlas is of one scale: areas on the surface are to each other as in uv") {
  const PolygonMesh mesh = torus(32, 16);
  const Result<UnwrapResult> result = unwrap(mesh, {});
  REQUIRE(result.ok());
  const UnwrapResult& r = result.value();
  std::vector<double> uvArea(r.report.charts.size(), 0);
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    for (std::uint32_t k = mesh.faceOffsets[f] + 1; k + 1 < mesh.faceOffsets[f + 1]; ++k) {
      const double *a = &r.uv[2 * r.cornerUv[mesh.faceOffsets[f]]], *b = &r.uv[2 * r.cornerUv[k]],
                   *c = &r.uv[2 * r.cornerUv[k + 1]];
      uvArea[r.chartOfFace[f]] +=
          ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
  double used = 0;
  const double density = r.report.atlas.texelDensity / r.report.atlas.resolution;
  for (std::size_t i = 0; i < uvArea.size(); ++i) {
    CHECK(uvArea[i] == Approx(r.report.charts[i].area * density * density).epsilon(1e-9));
    used += uvArea[i];
  }
  CHECK(r.report.atlas.utilization == Approx(used).epsilon(1e-9));
}

TEST_CASE("seams that are asked for are cut") {
  const PolygonMesh mesh = torus(12, 8);
  UnwrapOptions options;
  options.seams.isAuto = false;
  options.seams.edges = {{0, 1}, {2, 1}};
  const Result<UnwrapResult> result = unwrap(mesh, options);
  REQUIRE(result.ok());
  CHECK(result.value().report.valid);
  for (const EdgeVertices& wanted : {EdgeVertices{0, 1}, EdgeVertices{1, 2}})
    CHECK(std::count(result.value().seams.begin(), result.value().seams.end(), wanted) == 1);
  options.seams.edges = {{0, 50}};
  CHECK(unwrap(mesh, options).status().code == StatusCode::InvalidOption);
}

TEST_CASE("a run can be cancelled at each stage") {
  const PolygonMesh mesh = torus(40, 30);
  std::vector<Stage> stages;
  UnwrapOptions options;
  options.progress = [&](const Progress& p) {
    if (stages.empty() || stages.back() != p.stage) stages.push_back(p.stage);
    return true;
  };
  REQUIRE(unwrap(mesh, options).ok());
  CHECK(stages ==
        std::vector<Stage>{Stage::Surface, Stage::Seams, Stage::Solve, Stage::Pack, Stage::Check});
  for (const Stage last : stages) {
    options.progress = [&](const Progress& p) { return p.stage != last; };
    CHECK(unwrap(mesh, options).status().code == StatusCode::Aborted);
  }
}

TEST_CASE("lists of seams") {
  const auto parsed = [](const char* text) { return parseSeams(text).value(); };
  CHECK(parsed("auto").isAuto);
  CHECK(parsed("auto").sharpDegrees == 180);
  CHECK_FALSE(parsed("none").isAuto);
  CHECK_FALSE(parsed("sharp=45").isAuto);
  CHECK(parsed("sharp=45").sharpDegrees == 45);
  CHECK(parsed("sharp=45.5,auto").isAuto);
  CHECK(parsed("sharp=45.5,auto").sharpDegrees == 45.5);
  CHECK(parsed("uv").followsTexcoords);
  CHECK_FALSE(parsed("uv").isAuto);
  CHECK_FALSE(parsed("uv").followsMaterials);
  CHECK(parsed("material,auto").followsMaterials);
  CHECK_FALSE(parsed("material,auto").followsTexcoords);
  CHECK(parsed("hard").followsHardEdges);
  CHECK_FALSE(parsed("hard").isAuto);
  CHECK(parsed("auto,hard,sharp=30").followsHardEdges);
  CHECK_FALSE(parsed("auto").followsHardEdges);
  for (const char* text :
       {"", ",", "auto,", "none,hard", "hard=1", "sharp=", "sharp=0", "sharp=181", "sharp=nan",
        "none,auto", "none,uv", "Auto", "auto none", "file=x"})
    CHECK(parseSeams(text).status().code == StatusCode::InvalidOption);
}

TEST_CASE("a triangle mesh keeps all of its triangles in their order") {
  PolygonMesh mesh = torus(12, 8);
  std::vector<std::uint32_t> faces(mesh.faceVertices);
  // A face without area between two others, a repeated one, and one at an unused place.
  faces.insert(faces.begin() + 30, {faces[0], faces[1], faces[1]});
  faces.insert(faces.end(), {faces[0], faces[1], faces[2]});
  mesh.positions.insert(mesh.positions.end(), {9, 9, 9});
  const auto far = static_cast<std::uint32_t>(mesh.vertexCount() - 1);
  faces.insert(faces.end(), {far, far, far});
  mesh = makeTriangleMesh(mesh.positions, faces);
  const Result<UnwrapResult> result = unwrap(mesh, {});
  REQUIRE(result.ok());
  const UnwrapResult& r = result.value();
  REQUIRE(r.triangles.size() == faces.size());
  REQUIRE(r.chartOfTriangle.size() == mesh.faceCount());
  for (std::size_t c = 0; c < faces.size(); ++c) CHECK(r.vertexMap[r.triangles[c]] == faces[c]);
  CHECK(r.triangles == r.cornerVertex);
  CHECK(r.chartOfTriangle == r.chartOfFace);
  for (std::size_t f = 0; f + 1 < mesh.faceCount(); ++f)
    CHECK(r.chartOfTriangle[f] < r.report.charts.size());
  CHECK(r.chartOfTriangle[10] != r.chartOfTriangle[mesh.faceCount() - 2]);
  CHECK(r.chartOfTriangle.back() == kNoChart);
}

TEST_CASE("polygons become the triangles that were flattened") {
  const PolygonMesh mesh = star(7);
  const Result<UnwrapResult> result = unwrap(mesh, {});
  REQUIRE(result.ok());
  const UnwrapResult& r = result.value();
  CHECK(r.triangles.size() == 3 * (mesh.faceVertices.size() - 2 * mesh.faceCount()));
  double area = 0;
  for (std::size_t t = 0; t < r.triangles.size(); t += 3) {
    const auto at = [&](std::size_t k) { return &r.uv[2 * r.vertexUv[r.triangles[t + k]]]; };
    const double *a = at(0), *b = at(1), *c = at(2);
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    CHECK(twice > 0);
    area += twice / 2;
  }
  CHECK(area == Approx(r.report.atlas.utilization).epsilon(1e-9));
}

TEST_CASE("charts with pins stay where these put them, and the others go around", "[pin]") {
  const PolygonMesh mesh = torus(24, 12);
  UnwrapOptions options;
  options.seams = inTwo(24, 12);
  const Result<UnwrapResult> free = unwrap(mesh, options);
  REQUIRE(free.ok());
  REQUIRE(free.value().report.charts.size() == 2);
  // Two vertices inside the chart of face 0.
  const std::uint32_t first = 24 * 3 + 2, second = 24 * 9 + 4;
  options.pins = {{first, {0.25, 0.3}}, {second, {0.25, 0.6}}};
  const Result<UnwrapResult> result = unwrap(mesh, options);
  INFO(result.status().message);
  REQUIRE(result.ok());
  const UnwrapResult& r = result.value();
  CHECK(r.report.valid);
  const std::uint32_t chart = r.chartOfFace[0];
  REQUIRE(r.report.charts[chart].pins);
  CHECK(r.report.charts[chart].pins->count == 2);
  CHECK_FALSE(r.report.charts[1 - chart].pins);
  for (std::size_t c = 0; c < mesh.faceVertices.size(); ++c)
    for (const Pin& pin : options.pins)
      if (mesh.faceVertices[c] == pin.vertex) {
        CHECK(r.uv[2 * r.cornerUv[c]] == pin.uv[0]);
        CHECK(r.uv[2 * r.cornerUv[c] + 1] == pin.uv[1]);
      }
  // Two vertices of the other chart, pinned at the same place.
  options.pins.push_back({24 * 3 + 12, {0.25, 0.35}});
  options.pins.push_back({24 * 9 + 18, {0.25, 0.5}});
  const Status overlap = unwrap(mesh, options).status();
  CHECK(overlap.code == StatusCode::InvalidOption);
  CHECK_THAT(overlap.message, Catch::Contains("overlap"));
}

TEST_CASE("a pin on a seam says by a face which texcoord it means", "[pin]") {
  const PolygonMesh mesh = torus(24, 12);
  UnwrapOptions options;
  options.seams = inTwo(24, 12);
  const std::uint32_t seam = 24 * 5 + 6, inside = 24 * 9 + 4;
  options.pins = {{seam, {0.5, 0.4}}, {inside, {0.5, 0.5}}};
  const Result<UnwrapResult> ambiguous = unwrap(mesh, options);
  CHECK(ambiguous.status().code == StatusCode::InvalidOption);
  CHECK_THAT(ambiguous.status().message,
             Catch::Contains("vertex " + std::to_string(seam)) && Catch::Contains("seam"));
  std::uint32_t face = 0;
  const auto uses = [&](std::uint32_t f, std::uint32_t v) {
    return std::count(mesh.faceVertices.begin() + mesh.faceOffsets[f],
                      mesh.faceVertices.begin() + mesh.faceOffsets[f + 1], v) > 0;
  };
  while (!uses(face, seam) || !uses(face, seam - 1)) ++face;
  options.pins[0].face = face;
  const Result<UnwrapResult> result = unwrap(mesh, options);
  INFO(result.status().message);
  REQUIRE(result.ok());
  const UnwrapResult& r = result.value();
  CHECK(r.report.valid);
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c)
      if (mesh.faceVertices[c] == seam)
        CHECK((r.uv[2 * r.cornerUv[c]] == 0.5 && r.uv[2 * r.cornerUv[c] + 1] == 0.4) ==
              (r.chartOfFace[f] == r.chartOfFace[face]));
  options.pins[1].uv = {0.25, 9};
  CHECK_THAT(unwrap(mesh, options).status().message, Catch::Contains("outside the unit square"));
  options.pins.pop_back();
  CHECK_THAT(unwrap(mesh, options).status().message,
             Catch::Contains("only pinned vertex of its chart"));
}

TEST_CASE("rounded texcoords are single precision numbers, also when v points down") {
  UnwrapOptions options;
  options.precision = Precision::Single;
  const Result<UnwrapResult> result = unwrap(torus(24, 12), options);
  REQUIRE(result.ok());
  CHECK(result.value().report.valid);
  CHECK(result.value().report.notes.empty());
  for (const double x : result.value().uv) {
    CHECK(static_cast<double>(static_cast<float>(x)) == x);
    CHECK(static_cast<double>(static_cast<float>(1 - x)) == 1 - x);
  }
}

TEST_CASE("seams that should be symmetric, but cannot be, are named", "[unwrap]") {
  const auto isNoted = [](const PolygonMesh& mesh, SymmetricSeams symmetric, bool isGiven) {
    UnwrapOptions options;
    options.symmetricSeams = symmetric;
    if (isGiven) options.seams.edges.push_back({mesh.faceVertices[0], mesh.faceVertices[1]});
    const Result<UnwrapResult> r = unwrap(mesh, options);
    REQUIRE(r.ok());
    const std::vector<std::string>& notes = r.value().report.notes;
    return std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
      return note.find("seams are not symmetric") != std::string::npos;
    });
  };
  const PolygonMesh ring = torus(24, 12);
  PolygonMesh crooked = ring;
  std::mt19937 random(4);
  for (double& x : crooked.positions) x += 1e-2 * static_cast<double>(random() % 10);
  CHECK(isNoted(crooked, SymmetricSeams::Always, false));
  CHECK(isNoted(ring, SymmetricSeams::Always, true));
  CHECK_FALSE(isNoted(ring, SymmetricSeams::Always, false));
  CHECK_FALSE(isNoted(crooked, SymmetricSeams::Auto, false));
}
