#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "abflat/unwrap.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A grid of quads in the plane.
PolygonMesh strip(unsigned columns, unsigned rows, double width, double height) {
  PolygonMesh mesh;
  mesh.faceOffsets = {0};
  for (unsigned j = 0; j <= rows; ++j)
    for (unsigned i = 0; i <= columns; ++i)
      mesh.positions.insert(mesh.positions.end(), {width * i / columns, height * j / rows, 0});
  for (unsigned j = 0; j < rows; ++j)
    for (unsigned i = 0; i < columns; ++i) {
      const unsigned v = j * (columns + 1) + i, above = v + columns + 1;
      for (const unsigned w : {v, v + 1, above + 1, above}) mesh.faceVertices.push_back(w);
      mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
    }
  return mesh;
}

/// Adds a mesh, moved.
void append(const PolygonMesh& part, const std::array<double, 3>& by, PolygonMesh& out) {
  const auto first = static_cast<std::uint32_t>(out.vertexCount());
  for (std::size_t i = 0; i < part.positions.size(); ++i)
    out.positions.push_back(part.positions[i] + by[i % 3]);
  for (const std::uint32_t v : part.faceVertices) out.faceVertices.push_back(first + v);
  const std::uint32_t corners = out.faceOffsets.back();
  for (std::size_t f = 1; f < part.faceOffsets.size(); ++f)
    out.faceOffsets.push_back(corners + part.faceOffsets[f]);
}

PolygonMesh sheared(PolygonMesh mesh) {
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    mesh.positions[3 * v] += mesh.positions[3 * v + 1] / 3;
  return mesh;
}

/// A strip of squares, folded like a staircase.
PolygonMesh folded(unsigned squares) {
  PolygonMesh mesh = strip(squares, 1, squares, 1);
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    double* p = &mesh.positions[3 * v];
    const double along = std::round(p[0]);
    p[0] = std::ceil(along / 2);
    p[2] = std::floor(along / 2);
  }
  return mesh;
}

/// A planar ring with a round hole.
PolygonMesh ring(double inner, unsigned columns) {
  PolygonMesh mesh = cylinder(columns, 4);
  double low = 1e9, high = -1e9;
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    low = std::min(low, mesh.positions[3 * v + 2]);
    high = std::max(high, mesh.positions[3 * v + 2]);
  }
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    double* p = &mesh.positions[3 * v];
    const double radius = inner + (1 - inner) * (p[2] - low) / (high - low);
    const double now = std::hypot(p[0], p[1]);
    p[0] *= radius / now;
    p[1] *= radius / now;
    p[2] = 0;
  }
  return mesh;
}

/// A tube along a trefoil: one long chart that bends.
PolygonMesh knot(unsigned columns, unsigned rows, double radius) {
  const double pi = std::acos(-1.0);
  const auto curve = [](double t) {
    const double r = (2 + std::cos(1.5 * t)) / 2;
    return std::array<double, 3>{r * std::cos(t), r * std::sin(t), std::sin(1.5 * t) / 2};
  };
  PolygonMesh mesh = torus(columns, rows);
  mesh.positions.clear();
  for (unsigned j = 0; j < rows; ++j)
    for (unsigned i = 0; i < columns; ++i) {
      const double t = 4 * pi * i / columns, a = 2 * pi * j / rows;
      const auto p = curve(t), q = curve(t + 1e-3);
      // Directions across the curve: away from its middle, and perpendicular to that.
      std::array<double, 3> along{}, out{}, side{};
      for (std::size_t d = 0; d < 3; ++d) along[d] = (q[d] - p[d]) / 1e-3;
      const double norm = std::hypot(along[0], std::hypot(along[1], along[2]));
      for (double& x : along) x /= norm;
      const double share = p[0] * along[0] + p[1] * along[1] + p[2] * along[2];
      for (std::size_t d = 0; d < 3; ++d) out[d] = p[d] - share * along[d];
      const double away = std::hypot(out[0], std::hypot(out[1], out[2]));
      for (double& x : out) x /= away;
      for (std::size_t d = 0; d < 3; ++d)
        side[d] = along[(d + 1) % 3] * out[(d + 2) % 3] - along[(d + 2) % 3] * out[(d + 1) % 3];
      for (std::size_t d = 0; d < 3; ++d)
        mesh.positions.push_back(p[d] + radius * (std::cos(a) * out[d] + std::sin(a) * side[d]));
    }
  return mesh;
}

UnwrapOptions atLeast(double utilization) {
  UnwrapOptions out;
  out.minUtilization = utilization;
  return out;
}

const UnwrapOptions kAuto = atLeast(kAutoMinUtilization), kNever = atLeast(0);

}  // namespace

TEST_CASE("a long strip is cut across", "[cuts]") {
  const PolygonMesh mesh = strip(200, 4, 10, 0.2);
  const UnwrapResult whole = unwrapped(mesh, kNever), cut = unwrapped(mesh, kAuto);
  CHECK(whole.report.charts.size() == 1);
  CHECK(whole.report.atlas.packingCuts == 0);
  CHECK(whole.report.atlas.uncutTexelDensity == 0);
  CHECK(cut.report.charts.size() == 1 + static_cast<std::size_t>(cut.report.atlas.packingCuts));
  CHECK(cut.report.atlas.utilization > 10 * whole.report.atlas.utilization);
  CHECK(cut.report.atlas.uncutTexelDensity == whole.report.atlas.texelDensity);
  // Straight across: each cut is as long as the strip is wide.
  CHECK(cut.report.atlas.packingCutLength * std::sqrt(2.0) ==
        Approx(0.2 * cut.report.atlas.packingCuts));
  CHECK(cut.report.seams.relativeLength == Approx(cut.report.atlas.packingCutLength));
}

TEST_CASE("strips fill the tile, however long they are", "[cuts]") {
  for (const double length : {30.0, 100.0, 300.0, 1000.0}) {
    const PolygonMesh mesh = strip(static_cast<unsigned>(2 * length), 2, length, 1);
    const UnwrapResult cut = unwrapped(mesh, kAuto), asked = unwrapped(mesh, atLeast(0.7));
    INFO("length " << length);
    CHECK(cut.report.atlas.utilization > 0.75);
    CHECK(asked.report.atlas.utilization >= 0.7);
    CHECK(cut.report.notes.empty());
    // No more parts than lie beside each other in a square.
    CHECK(cut.report.atlas.packingCuts < 1.3 * std::sqrt(length));
    CHECK(cut.report.atlas.packingCutLength * std::sqrt(length) ==
          Approx(cut.report.atlas.packingCuts));
  }
}

TEST_CASE("long charts are cut together, since cutting one of them gains nothing", "[cuts]") {
  for (const unsigned count : {2u, 5u, 90u}) {
    PolygonMesh mesh;
    mesh.faceOffsets = {0};
    for (unsigned i = 0; i < count; ++i) {
      const bool isLong = i < 5;
      const PolygonMesh part = isLong ? strip(60, 1, 100, 0.5) : strip(1, 1, 1, 1);
      append(part, {0, 0, 1.0 * i}, mesh);
    }
    const UnwrapResult whole = unwrapped(mesh, kNever), cut = unwrapped(mesh, kAuto);
    INFO(count << " charts");
    CHECK(whole.report.charts.size() == count);
    CHECK(whole.report.atlas.utilization < 0.2);
    CHECK(cut.report.atlas.utilization > 0.6);
  }
}

TEST_CASE("with straight seams long charts are cut, and their parts are straight all around",
          "[cuts]") {
  UnwrapOptions options = kAuto;
  options.straightSeams = true;
  for (const PolygonMesh& mesh : {strip(200, 4, 100, 1), sheared(strip(120, 3, 60, 1))}) {
    const UnwrapResult cut = unwrapped(mesh, options);
    CHECK(cut.report.atlas.packingCuts > 0);
    CHECK(cut.report.atlas.utilization > 0.6);
    for (const UnwrapChart& chart : cut.report.charts) {
      REQUIRE(chart.straight);
      CHECK(chart.straight->released == 0);
      CHECK(chart.straight->deviation < 1e-6);
    }
  }
  // Others stay whole.
  CHECK(unwrapped(ring(0.8, 64), options).report.atlas.packingCuts == 0);
}

TEST_CASE("a side three times as long as wide stays whole", "[cuts]") {
  for (const PolygonMesh& mesh : {strip(24, 8, 3, 1), strip(80, 8, 10, 1)}) {
    const UnwrapResult cut = unwrapped(mesh, kAuto);
    CHECK(cut.report.atlas.packingCuts <= (mesh.vertexCount() < 300 ? 2 : 3));
  }
}

TEST_CASE("a note says why the tile stays empty", "[cuts]") {
  const auto noteOf = [](const PolygonMesh& mesh, const UnwrapOptions& options) {
    const UnwrapResult r = unwrapped(mesh, options);
    REQUIRE(r.report.notes.size() <= 1);
    return r.report.notes.empty() ? std::string() : r.report.notes[0];
  };
  const auto says = [](const std::string& note, const char* part) {
    INFO(note);
    CHECK(note.find(part) != std::string::npos);
  };
  const PolygonMesh fine = strip(100, 2, 50, 0.5), coarse = strip(1, 1, 50, 0.5);
  CHECK(noteOf(fine, kAuto).empty());
  CHECK(noteOf(fine, kNever).empty());
  CHECK(noteOf(fine, atLeast(0.5)).empty());
  says(noteOf(coarse, kAuto), "face 0 is as long as the tile");
  says(noteOf(coarse, atLeast(0.5)), ", not the 50 % asked for: face 0 is as long as the tile");
  UnwrapOptions given = kAuto, bounded = kAuto, dense = atLeast(0.5), pinned = atLeast(0.5);
  given.seams.isAuto = false;
  bounded.t = 2;
  dense.texelDensity = 10;
  pinned.pins = {{0, {0.1, 0.1}}, {100, {0.8, 0.1}}};
  says(noteOf(fine, given), "only if seams are automatic");
  says(noteOf(fine, bounded), "only if t is auto");
  says(noteOf(fine, dense), "the texel density is given");
  says(noteOf(fine, pinned), "pinned or kept");
  dense.minUtilization = kAutoMinUtilization;
  CHECK(noteOf(fine, dense).empty());
  says(noteOf(strip(40, 40, 1, 1), atLeast(1)), "not the 100 % asked for: no further cut");
}

TEST_CASE("a thin ring is cut through its hole", "[cuts]") {
  const PolygonMesh mesh = ring(0.95, 96);
  const UnwrapResult whole = unwrapped(mesh, kNever), cut = unwrapped(mesh, atLeast(0.6));
  CHECK(whole.report.seams.filledHoles == 1);
  CHECK(cut.report.seams.filledHoles == 0);
  CHECK(cut.report.atlas.utilization > 2.5 * whole.report.atlas.utilization);
}

TEST_CASE("what lies well is not cut in plain sight, unless asked for", "[cuts]") {
  for (const PolygonMesh& mesh : {strip(24, 4, 6, 1), ring(0.5, 48)}) {
    CAPTURE(mesh.vertexCount());
    const UnwrapResult whole = unwrapped(mesh, kNever), own = unwrapped(mesh, kAuto),
                       asked = unwrapped(mesh, atLeast(0.7));
    CHECK(own.report.atlas.packingCuts == 0);
    CHECK(own.uv == whole.uv);
    CHECK(asked.report.atlas.packingCuts > 0);
  }
}

TEST_CASE("charts are cut along creases where that brings texels", "[cuts]") {
  const PolygonMesh mesh = folded(7);
  const UnwrapResult whole = unwrapped(mesh, kNever), cut = unwrapped(mesh, kAuto);
  CHECK(whole.report.charts.size() == 1);
  CHECK(cut.report.atlas.packingCuts > 0);
  CHECK(cut.report.atlas.utilization > 2 * whole.report.atlas.utilization);
}

TEST_CASE("what fills its square is not cut", "[cuts]") {
  for (const PolygonMesh& mesh : {strip(10, 10, 1, 1), tetrahedron()}) {
    const UnwrapResult whole = unwrapped(mesh, kNever), cut = unwrapped(mesh, kAuto);
    if (whole.report.atlas.utilization < 0.9) continue;
    CHECK(cut.report.atlas.packingCuts == 0);
    CHECK(cut.uv == whole.uv);
  }
}

TEST_CASE("cuts for packing bring texels for their length, or are not made", "[cuts]") {
  const std::vector<PolygonMesh> meshes = {strip(40, 4, 3, 0.5),
                                           ring(0.5, 48),
                                           ring(0.8, 64),
                                           torus(60, 12),
                                           cylinder(40, 30),
                                           cone(24, 2),
                                           star(11),
                                           bumpyGrid(20, 14, 0.8, 2),
                                           folded(7)};
  int cuts = 0;
  for (const PolygonMesh& mesh : meshes)
    for (const double balance : {0.0, 0.2}) {
      UnwrapOptions options = kNever;
      options.balance = balance;
      const UnwrapResult whole = unwrapped(mesh, options);
      options.minUtilization = kAutoMinUtilization;
      const UnwrapResult cut = unwrapped(mesh, options);
      const AtlasReport& atlas = cut.report.atlas;
      const double gain = std::log(atlas.texelDensity / whole.report.atlas.texelDensity);
      const double more = cut.report.seams.relativeLength - whole.report.seams.relativeLength;
      CHECK(more == Approx(atlas.packingCutLength).margin(1e-12));
      if (atlas.packingCuts > 0)
        CHECK(gain > 0.04 * more + 0.02 * atlas.packingCuts);
      else
        CHECK(cut.uv == whole.uv);
      for (const UnwrapChart& c : cut.report.charts)
        CHECK(c.symmetricDirichlet <= options.maxStretch);
      cuts += atlas.packingCuts;
    }
  CHECK(cuts > 0);
}

TEST_CASE("a piece that comes out stretched too much is cut further, and all other cuts stay",
          "[cuts]") {
  int cuts = 0;
  for (const double radius : {0.2, 0.3, 0.4})
    for (const double balance : {0.0, 0.2}) {
      UnwrapOptions options = atLeast(0.6);
      options.balance = balance;
      options.maxStretch = balance == 0 ? 1.04 : 1.02;
      const UnwrapResult cut = unwrapped(knot(120, 14, radius), options);
      INFO("radius " << radius << ", balance " << balance);
      cuts += cut.report.atlas.packingCuts;
      CHECK(cut.report.atlas.utilization > 0.45);
      for (const UnwrapChart& c : cut.report.charts)
        CHECK(c.symmetricDirichlet <= options.maxStretch);
    }
  CHECK(cuts > 0);
}

TEST_CASE("charts are cut until they cover the share that is asked for", "[cuts]") {
  const PolygonMesh mesh = strip(60, 6, 6, 0.6);
  double before = 0;
  for (const double asked : {0.3, 0.5, 0.7}) {
    const UnwrapResult r = unwrapped(mesh, atLeast(asked));
    CHECK(r.report.atlas.utilization >= asked);
    CHECK(r.report.atlas.packingCutLength >= before);
    before = r.report.atlas.packingCutLength;
  }
}

TEST_CASE("cuts for packing are the same for any number of threads", "[cuts]") {
  const PolygonMesh mesh = ring(0.8, 64);
  UnwrapOptions options = atLeast(0.6);
  options.threads = 1;
  const UnwrapResult one = unwrapped(mesh, options);
  options.threads = 2;
  const UnwrapResult two = unwrapped(mesh, options);
  CHECK(one.report.atlas.packingCuts > 0);
  CHECK(one.uv == two.uv);
  CHECK(one.cornerUv == two.cornerUv);
}

TEST_CASE("what the user wants of charts is kept: nothing is cut for packing", "[cuts]") {
  const PolygonMesh mesh = strip(60, 4, 10, 0.5);
  UnwrapOptions given = kAuto, bounded = kAuto, dense = kAuto, pinned = kAuto;
  given.seams.isAuto = false;
  bounded.t = 2;
  dense.texelDensity = 10;
  pinned.pins = {{0, {0.1, 0.1}}, {60, {0.8, 0.1}}};
  for (const UnwrapOptions& options : {given, bounded, dense, pinned}) {
    const UnwrapResult r = unwrapped(mesh, options);
    CHECK(r.report.charts.size() == 1);
    CHECK(r.report.atlas.packingCuts == 0);
  }
  UnwrapOptions kept = kAuto;
  kept.reuse.known = knownLayout(unwrapped(mesh, kNever));
  kept.reuse.fixedCharts = {0};
  CHECK(unwrapped(mesh, kept).report.charts.size() == 1);
}

TEST_CASE("needles and faces that are far too large end in a valid atlas", "[cuts]") {
  for (const double far : {1e2, 1e4, 1e6, 1e9}) {
    PolygonMesh mesh = torus(24, 16);
    mesh.positions[3 * 77] += 0.48 * far;
    mesh.positions[3 * 77 + 1] -= 0.64 * far;
    mesh.positions[3 * 77 + 2] += 0.6 * far;
    UnwrapOptions options = kAuto;
    options.precision = Precision::Single;
    CHECK(unwrapped(mesh, options).report.atlas.texelDensity > 0);
  }
}
