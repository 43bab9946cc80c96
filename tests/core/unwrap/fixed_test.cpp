#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "abflat/texcoord_faces.h"
#include "abflat/unwrap.h"
#include "catch.h"
#include "pack/texels.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// The mesh with the texcoords of a result.
PolygonMesh withUv(PolygonMesh mesh, const UnwrapResult& r) {
  mesh.texcoords = r.uv;
  mesh.faceTexcoords = r.cornerUv;
  return mesh;
}

/// What is wrong with an atlas, judged by the texels of its triangles.
std::string complaintOf(const UnwrapResult& r) {
  PackOptions options;
  options.resolution = r.report.atlas.resolution;
  options.padding = r.report.atlas.padding;
  std::vector<PackShape> shapes(r.report.charts.size());
  Packing packing;
  packing.tiles = static_cast<std::uint32_t>(r.report.atlas.tiles);
  packing.placements.resize(shapes.size());
  for (std::size_t t = 0; t < r.chartOfTriangle.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      PackShape& shape = shapes[r.chartOfTriangle[t]];
      const double* uv = &r.uv[2 * r.vertexUv[r.triangles[3 * t + k]]];
      shape.triangles.push_back(static_cast<std::uint32_t>(shape.uv.size() / 2));
      shape.uv.insert(shape.uv.end(), uv, uv + 2);
    }
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    Placement& p = packing.placements[i];
    double u = 0, v = 0;  // of the middle
    for (std::size_t k = 0; k < shapes[i].uv.size(); k += 2) {
      u += 2 * shapes[i].uv[k] / static_cast<double>(shapes[i].uv.size());
      v += 2 * shapes[i].uv[k + 1] / static_cast<double>(shapes[i].uv.size());
    }
    p.tile = static_cast<std::uint32_t>(10 * std::floor(v) + std::floor(u));
    p.x = -p.column();
    p.y = -p.row();
  }
  return complaint(shapes, packing, options);
}

void checkKept(const PolygonMesh& mesh, const UnwrapResult& r, std::size_t count) {
  std::size_t fixed = 0;
  for (const UnwrapChart& c : r.report.charts) {
    fixed += c.fixed;
    CHECK(c.fixed == (c.solver == Solver::Given));
  }
  CHECK(fixed == count);
  for (std::uint32_t c = 0; c < mesh.faceVertices.size(); ++c) {
    if (!r.report.charts[r.chartOfFace[c / 3]].fixed) continue;
    for (std::size_t d = 0; d < 2; ++d)
      CHECK(r.uv[2 * r.cornerUv[c] + d] == mesh.texcoords[2 * mesh.faceTexcoords[c] + d]);
  }
}

}  // namespace

TEST_CASE("fixed islands stay bit by bit, and others are packed around them", "[fixed]") {
  const PolygonMesh plain = torus(24, 16);
  const UnwrapResult first = unwrapped(plain, severalCharts());
  REQUIRE(first.report.charts.size() > 2);
  const PolygonMesh mesh = withUv(plain, first);
  UnwrapOptions options = severalCharts();
  options.seams.isAuto = false;
  options.seams.sharpDegrees = 10;  // would cut everything into pieces
  options.reuse.fixedFaces = {first.report.charts[1].firstFace};
  const UnwrapResult one = unwrapped(mesh, options);
  checkKept(mesh, one, 1);
  CHECK(complaintOf(one) == "");
  const auto kept = [&](const UnwrapResult& r) {
    return static_cast<std::size_t>(
        std::count_if(r.chartOfFace.begin(), r.chartOfFace.end(),
                      [&](std::uint32_t c) { return r.report.charts[c].fixed; }));
  };
  CHECK(kept(one) == first.report.charts[1].faces);
  CHECK(one.report.charts.size() > first.report.charts.size());
  for (const bool rounds : {false, true}) {
    UnwrapOptions two = severalCharts();
    two.reuse.fixedFaces = {first.report.charts[0].firstFace, first.report.charts[1].firstFace};
    two.precision = rounds ? Precision::Single : Precision::Double;
    const UnwrapResult r = unwrapped(mesh, two);
    checkKept(mesh, r, 2);
    CHECK(complaintOf(r) == "");
    // Charts that are not disks keep their seams as well, and measures are those from solving.
    CHECK(r.report.charts[0].angularDistortion ==
          Approx(first.report.charts[0].angularDistortion).epsilon(1e-6));
  }
}

TEST_CASE("faces with texcoords have them at all corners", "[fixed]") {
  PolygonMesh mesh;
  CHECK(facesWithTexcoords(mesh).status().code == StatusCode::InvalidOption);
  mesh.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  mesh.faceOffsets = {0, 4, 7, 10};
  mesh.faceVertices = {0, 1, 2, 3, 0, 1, 2, 0, 2, 3};
  mesh.texcoords = {0, 0};
  for (const std::uint32_t without : {0u, 4u, 9u}) {
    mesh.faceTexcoords.assign(10, 0);
    mesh.faceTexcoords[without] = kNoTexcoord;
    std::vector<std::uint32_t> expected;
    for (std::uint32_t f = 0; f < 3; ++f)
      if (without < mesh.faceOffsets[f] || without >= mesh.faceOffsets[f + 1])
        expected.push_back(f);
    const Result<std::vector<std::uint32_t>> faces = facesWithTexcoords(mesh);
    REQUIRE(faces.ok());
    CHECK(faces.value() == expected);
  }
}

TEST_CASE("all of an atlas can be fixed", "[fixed]") {
  for (const PolygonMesh& plain : {torus(24, 16), cylinder(12, 6), tetrahedron()}) {
    const UnwrapResult first = unwrapped(plain, severalCharts());
    const PolygonMesh mesh = withUv(plain, first);
    UnwrapOptions options = severalCharts();
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) options.reuse.fixedFaces.push_back(f);
    const UnwrapResult again = unwrapped(mesh, options);
    checkKept(mesh, again, first.report.charts.size());
    CHECK(again.seams == first.seams);
    CHECK(again.report.atlas.utilization == Approx(first.report.atlas.utilization));
  }
}

TEST_CASE("an island need not be a disk", "[fixed]") {
  // A flat ring beside a torus.
  PolygonMesh mesh = cylinder(12, 2);
  const std::size_t vertices = mesh.vertexCount(), faces = mesh.faceCount();
  for (std::size_t v = 0; v < vertices; ++v) {
    const double r = (4 - mesh.positions[3 * v + 2]) / 10;
    mesh.texcoords.insert(mesh.texcoords.end(),
                          {0.5 + r * mesh.positions[3 * v], 0.5 + r * mesh.positions[3 * v + 1]});
  }
  mesh.faceTexcoords = mesh.faceVertices;
  const PolygonMesh other = torus(12, 8);
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const std::uint32_t v : other.faceVertices) {
    mesh.faceVertices.push_back(v + static_cast<std::uint32_t>(vertices));
    mesh.faceTexcoords.push_back(kNoTexcoord);
    if (mesh.faceVertices.size() % 3 == 0)
      mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
  }
  UnwrapOptions options = severalCharts();
  options.reuse.fixedFaces = {0};
  for (const bool isStraight : {false, true}) {
    options.straightSeams = isStraight;
    const UnwrapResult r = unwrapped(mesh, options);
    checkKept(mesh, r, 1);
    CHECK(complaintOf(r) == "");
    CHECK(r.report.charts[0].faces == faces);
    CHECK(std::count(r.chartOfFace.begin(), r.chartOfFace.end(), 0u) ==
          static_cast<std::ptrdiff_t>(faces));
  }
}

TEST_CASE("islands without a boundary are treated alike whether seams are straight or not",
          "[fixed]") {
  for (const double height : {1.0, 0.0}) {
    PolygonMesh mesh = tetrahedron();
    // All on a line: without area both on the surface and in the atlas, and so not flipped.
    for (std::size_t i = 0; i < mesh.positions.size() && height == 0; ++i)
      mesh.positions[i] = i % 3 == 0 ? static_cast<double>(i) : 0;
    for (std::uint32_t v = 0; v < 4; ++v) {
      const double u = 0.2 * (v + 1.0);
      mesh.texcoords.insert(mesh.texcoords.end(), {u, 0.5 + 0.1 * height * (v % 2)});
    }
    mesh.faceTexcoords = mesh.faceVertices;
    UnwrapOptions options;
    options.reuse.fixedFaces = {0};
    const Result<UnwrapResult> plain = unwrap(mesh, options);
    options.straightSeams = true;
    const Result<UnwrapResult> straight = unwrap(mesh, options);
    CHECK(plain.ok() == (height == 0));
    REQUIRE(straight.ok() == plain.ok());
    CHECK(straight.status().message == plain.status().message);
    if (plain.ok()) CHECK(straight.value().uv == plain.value().uv);
  }
}

TEST_CASE("fixed charts are in tiles of their own where there are several", "[fixed]") {
  const PolygonMesh plain = torus(24, 16);
  const UnwrapResult first = unwrapped(plain, severalCharts());
  PolygonMesh mesh = withUv(plain, first);
  for (std::size_t i = 0; i < mesh.texcoords.size(); i += 2) mesh.texcoords[i] += 2;
  UnwrapOptions options = severalCharts();
  options.reuse.fixedFaces = {0};
  CHECK(unwrap(mesh, options).status().message.find("outside the unit square") !=
        std::string::npos);
  options.udim = true;
  options.texelDensity = 2 * first.report.atlas.texelDensity;
  const UnwrapResult r = unwrapped(mesh, options);
  checkKept(mesh, r, 1);
  CHECK(r.report.atlas.tiles >= 3);
  CHECK(r.report.atlas.texelDensity == options.texelDensity);
  CHECK(complaintOf(r) == "");
}

TEST_CASE("what cannot be fixed is named", "[fixed]") {
  const PolygonMesh plain = torus(12, 8);
  const UnwrapResult first = unwrapped(plain, severalCharts());
  const PolygonMesh good = withUv(plain, first);
  UnwrapOptions options = severalCharts();
  options.reuse.fixedFaces = {5};
  const auto message = [&](const PolygonMesh& mesh) {
    const Result<UnwrapResult> result = unwrap(mesh, options);
    CHECK(result.status().code == StatusCode::InvalidOption);
    return result.status().message;
  };
  const auto says = [&](const PolygonMesh& mesh, const std::string& part) {
    const std::string text = message(mesh);
    INFO(text);
    return text.find(part) != std::string::npos;
  };
  CHECK(says(plain, "the mesh has no texcoords to keep"));
  PolygonMesh bad = good;
  bad.faceTexcoords[15] = kNoTexcoord;
  CHECK(says(bad, "face 5 cannot keep its texcoords: a corner has none"));
  bad = good;
  for (std::size_t i = 0; i < bad.texcoords.size(); i += 2) bad.texcoords[i] = 1 - bad.texcoords[i];
  CHECK(says(bad, "'s texcoords are mirrored"));
  bad = good;
  for (double& x : bad.texcoords) x *= 3;
  CHECK(says(bad, "outside the unit square"));
  // One island, shrunk, within a face of another.
  bad = good;
  const std::uint32_t around = first.report.charts[0].firstFace;
  const std::uint32_t stacked = first.report.charts[1].firstFace;
  const auto at = [&](std::uint32_t corner, std::size_t d) {
    return good.texcoords[2 * good.faceTexcoords[corner] + d];
  };
  for (std::uint32_t c = 0; c < bad.faceTexcoords.size(); ++c)
    if (first.chartOfFace[c / 3] == 1) {
      bad.faceTexcoords[c] = static_cast<std::uint32_t>(bad.texcoords.size() / 2);
      for (std::size_t d = 0; d < 2; ++d) {
        const double middle =
            (at(3 * around, d) + at(3 * around + 1, d) + at(3 * around + 2, d)) / 3;
        bad.texcoords.push_back(middle + 1e-4 * (at(c, d) - at(3 * stacked, d)));
      }
    }
  options.reuse.fixedFaces = {around, stacked};
  CHECK(says(bad, " overlap. "));
  options.reuse.fixedFaces = {500};
  CHECK(says(good, "face 500 cannot keep its texcoords: the mesh has only 192 faces"));
}

TEST_CASE("islands that cannot stay are unwrapped, the others stay, and a note names them",
          "[fixed]") {
  const PolygonMesh plain = torus(24, 16);
  const UnwrapResult first = unwrapped(plain, severalCharts());
  const std::size_t count = first.report.charts.size();
  REQUIRE(count > 3);
  const PolygonMesh good = withUv(plain, first);
  UnwrapOptions options = severalCharts();
  for (std::uint32_t f = 0; f < good.faceCount(); ++f) options.reuse.fixedFaces.push_back(f);
  options.reuse.keepsValidOnly = true;
  checkKept(good, unwrapped(good, options), count);
  CHECK(unwrapped(good, options).report.notes.empty());

  // One chart is spoilt in each of these ways; all others keep their texcoords.
  using Spoil = std::function<void(double*)>;
  const std::pair<const char*, Spoil> ways[] = {
      {"is mirrored", [](double* uv) { uv[0] = 1 - uv[0]; }},
      {"is degenerate", [](double* uv) { uv[0] = 0.5; }},
      {"leaves the unit square", [](double* uv) { uv[1] += 1.5; }},
  };
  for (const auto& [why, spoil] : ways) {
    for (std::uint32_t chart = 0; chart < count; ++chart) {
      PolygonMesh mesh = good;
      std::vector<std::uint8_t> isSpoilt(mesh.texcoords.size() / 2, 0);
      for (std::uint32_t c = 0; c < mesh.faceTexcoords.size(); ++c)
        if (first.chartOfFace[c / 3] == chart && !isSpoilt[mesh.faceTexcoords[c]]++)
          spoil(&mesh.texcoords[2 * mesh.faceTexcoords[c]]);
      const UnwrapResult r = unwrapped(mesh, options);
      CHECK(r.report.valid);
      CHECK(complaintOf(r) == "");
      checkKept(mesh, r, count - 1);
      REQUIRE(r.report.notes.size() == 1);
      INFO(r.report.notes[0]);
      CHECK(r.report.notes[0].find("kept " + std::to_string(count - 1) + " of " +
                                   std::to_string(count) + " UV islands") == 0);
      CHECK(r.report.notes[0].find(why) != std::string::npos);
    }
  }
}

TEST_CASE("of islands that overlap, those that overlap no larger one stay", "[fixed]") {
  const PolygonMesh plain = torus(24, 16);
  const UnwrapResult first = unwrapped(plain, severalCharts());
  const auto count = static_cast<std::uint32_t>(first.report.charts.size());
  UnwrapOptions options = severalCharts();
  for (std::uint32_t f = 0; f < plain.faceCount(); ++f) options.reuse.fixedFaces.push_back(f);
  options.reuse.keepsValidOnly = true;
  std::uint32_t seed = 1;
  const auto random = [&] { return (seed = seed * 1664525 + 1013904223) / 4294967296.0; };
  for (int run = 0; run < 20; ++run) {
    PolygonMesh mesh = withUv(plain, first);
    std::vector<std::array<double, 3>> to;
    for (std::uint32_t i = 0; i < count; ++i)
      to.push_back({0.3 * random(), 0.3 * random(), 0.4 + 0.3 * random()});
    std::vector<std::uint8_t> isMoved(mesh.texcoords.size() / 2, 0);
    for (std::uint32_t c = 0; c < mesh.faceTexcoords.size(); ++c) {
      const auto& [u, v, scale] = to[first.chartOfFace[c / 3]];
      double* uv = &mesh.texcoords[2 * mesh.faceTexcoords[c]];
      if (isMoved[mesh.faceTexcoords[c]]++) continue;
      uv[0] = u + scale * uv[0];
      uv[1] = v + scale * uv[1];
    }
    const UnwrapResult r = unwrapped(mesh, options);
    CHECK(r.report.valid);
    const auto fixed = static_cast<std::size_t>(
        std::count_if(r.report.charts.begin(), r.report.charts.end(),
                      [](const UnwrapChart& chart) { return chart.fixed; }));
    CHECK(fixed > 0);
    checkKept(mesh, r, fixed);
    CHECK((fixed == count) == r.report.notes.empty());
  }
}

TEST_CASE("a texel density is kept in as many tiles as it takes", "[fixed]") {
  const PolygonMesh mesh = torus(24, 16);
  UnwrapOptions options = severalCharts();
  const double most = unwrapped(mesh, options).report.atlas.texelDensity;
  options.texelDensity = most / 2;
  UnwrapResult r = unwrapped(mesh, options);
  CHECK(r.report.atlas.tiles == 1);
  CHECK(r.report.atlas.texelDensity == most / 2);
  options.texelDensity = 2 * most;
  const Status s = unwrap(mesh, options).status();
  CHECK(s.code == StatusCode::AtlasTooSmall);
  CHECK(s.message.find("Lower the density") != std::string::npos);
  options.udim = true;
  for (const bool rounds : {false, true}) {
    options.precision = rounds ? Precision::Single : Precision::Double;
    r = unwrapped(mesh, options);
    CHECK(r.report.atlas.tiles >= 4);
    CHECK(complaintOf(r) == "");
  }
  options.texelDensity = kAutoTexelDensity;
  CHECK(unwrap(mesh, options).status().code == StatusCode::InvalidOption);
}
