#include "seam/symmetric_seams.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"
#include "mesh/triangle_geometry.h"
#include "support/cut_meshes.h"
#include "support/isosurface.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Half of an animal: a body, a head, and two legs and a horn that stick out. The plane is x = -1.
double animal(double x, double y, double z) {
  const auto ball = [&](double px, double py, double pz, double r) {
    return std::sqrt((x - px) * (x - px) + (y - py) * (y - py) + (z - pz) * (z - pz)) - r;
  };
  const auto stick = [&](double px, double py, double pz, double length, double r) {
    const double along = std::clamp(pz - z, 0.0, length);
    return ball(px, py, pz - along, r);
  };
  return std::min({ball(-1, 0.2, 0, 0.45), ball(-1, -0.45, 0.35, 0.32),
                   stick(-0.7, 0.35, -0.2, 0.6, 0.13), stick(-0.72, -0.1, -0.2, 0.6, 0.12),
                   stick(-0.8, -0.45, 0.85, 0.3, 0.07)});
}

/// A mesh and its mirror image at the plane x = -1, joined there.
PolygonMesh withImage(const PolygonMesh& half) {
  std::vector<double> positions = half.positions;
  std::vector<std::uint32_t> image, triangles = half.faceVertices;
  for (std::uint32_t v = 0; v < half.positions.size() / 3; ++v) {
    const double* p = &half.positions[3 * v];
    const bool isOnPlane = p[0] == -1;
    image.push_back(isOnPlane ? v : static_cast<std::uint32_t>(positions.size() / 3));
    if (!isOnPlane) positions.insert(positions.end(), {-2 - p[0], p[1], p[2]});
  }
  for (std::size_t c = 0; c < half.faceVertices.size(); c += 3)
    for (const std::size_t k : {0, 2, 1}) triangles.push_back(image[half.faceVertices[c + k]]);
  return makeTriangleMesh(std::move(positions), std::move(triangles));
}

PolygonMesh symmetricAnimal() { return withImage(isosurface(26, animal)); }

SeamOptions with(SymmetricSeams symmetric) {
  SeamOptions out;
  out.maxStretch = 1.02;
  out.symmetricSeams = symmetric;
  return out;
}

/// Vertices moved at random, by up to a share of the size.
PolygonMesh shaken(PolygonMesh mesh, double share) {
  std::mt19937 random(1);
  constexpr double kSize = 2;
  for (double& x : mesh.positions)
    x += kSize * share * (2 * (static_cast<double>(random()) / std::mt19937::max()) - 1);
  return mesh;
}

/// With something that sticks out of one side of the body.
PolygonMesh withKnob(PolygonMesh mesh) {
  for (std::size_t v = 0; v < mesh.positions.size(); v += 3) {
    double* p = &mesh.positions[v];
    const double near = std::hypot(p[1] - 0.2, p[2]) / 0.2;
    if (p[0] > -0.8 && near < 1) p[0] += 0.5 * std::sqrt(1 - near * near);
  }
  return mesh;
}

double shareWithImage(const SeamMesh& mesh, const Mirror& mirror, const Seams& seams) {
  double all = 0, found = 0;
  for (const SurfaceCorner h : seams.ids()) {
    if (!seams[h]) continue;
    all += mesh.length[h];
    if (mirror.hasImage(h)) found += mesh.length[h];
  }
  return found / all;
}

template <typename Test>
SurfaceCorner firstEdge(const SeamMesh& mesh, Test test) {
  for (const SurfaceCorner h : mesh.corners())
    if (test(h)) return h;
  return {};
}

std::size_t edgesWithImage(const Mirror& mirror) {
  const auto hasImage = [](SurfaceCorner h) { return h.exists(); };
  return static_cast<std::size_t>(
      std::count_if(mirror.image.begin(), mirror.image.end(), hasImage));
}

}  // namespace

TEST_CASE("a plane of symmetry is found wherever it lies", "[seams][symmetry]") {
  const PolygonMesh mesh = symmetricAnimal();
  for (const PolygonMesh& m :
       {mesh, transformed(mesh, 1, {0, 0, 0}), transformed(mesh, 1e-5, {3, 4, 5})}) {
    const SeamMesh seamMesh = Cuttable(m).seamMesh;
    const Mirror mirror = findMirror(seamMesh);
    REQUIRE(mirror);
    CHECK(edgesWithImage(mirror) == mirror.image.size());
    for (const SurfaceCorner h : mirror.image.ids()) {
      const SurfaceCorner image = mirror.image[h];
      REQUIRE(mirror.image[image] == h);
      REQUIRE(std::abs(seamMesh.length[image] - seamMesh.length[h]) < 1e-4);
      REQUIRE(mirror.side[seamMesh.vertexOfCorner[h]] ==
              -mirror.side[seamMesh.vertexOfCorner[image]]);
    }
  }
}

TEST_CASE("a mesh that is not its own image has no plane of symmetry", "[seams][symmetry]") {
  CHECK_FALSE(findMirror(Cuttable(isosurface(24, noise(2, 3))).seamMesh));
  CHECK_FALSE(findMirror(Cuttable(isosurface(26, animal)).seamMesh));
  // Everything lies in the plane z = 0, which says nothing, and random places have no images.
  CHECK_FALSE(findMirror(Cuttable(bumpyGrid(9, 7, 0.0, 3)).seamMesh));
}

TEST_CASE("the plane is cut only in charts that are narrow for its length", "[seams][symmetry]") {
  const Cuttable c(symmetricAnimal());
  const SeamMesh& mesh = c.seamMesh;
  const Mirror mirror = findMirror(mesh);
  REQUIRE(mirror);
  const Seams none(mesh.twin.size(), 0);
  Seams seams = none;
  cutAlongPlane(mesh, mirror, 1e-3, seams);
  CHECK(seams == none);
  cutAlongPlane(mesh, mirror, 1e3, seams);
  CHECK(cutAlong(mesh, seams).charts.size() == 2);
  for (const SurfaceCorner h : seams.ids())
    if (seams[h]) REQUIRE(mirror.sideOf(mesh, h) == 0);
}

TEST_CASE("images of cuts are cut as well, if that leaves disks", "[seams][symmetry]") {
  const Cuttable c(symmetricAnimal());
  const SeamMesh& mesh = c.seamMesh;
  const Mirror mirror = findMirror(mesh);
  REQUIRE(mirror);
  Seams before(mesh.twin.size(), 0);
  const auto isBesidePlane = [&](SurfaceCorner h) {
    return mirror.side[mesh.tail(h)] == 0 && mirror.sideOf(mesh, h) == 1;
  };
  const SurfaceCorner slit = firstEdge(mesh, isBesidePlane);
  for (const bool isPlaneCut : {false, true}) {
    if (isPlaneCut) cutAlongPlane(mesh, mirror, 1e3, before);
    Seams seams = before;
    seams[slit] = seams[mesh.twin[slit]] = 1;
    // Both slits begin at the same vertex, so together they are one, and the rest is a disk.
    CHECK(addImages(mesh, mirror, before, seams, {}).size() == 2);
    CHECK(mirroredShare(mesh, mirror, seams) == 1);
    for (const CutSurface::Chart& chart : cutAlong(mesh, seams).charts) CHECK(chart.isDisk());
  }
  // An edge far from its image would leave a ring.
  const auto isFar = [&](SurfaceCorner h) {
    return mirror.side[mesh.tail(h)] == 1 && mirror.side[mesh.head(h)] == 1;
  };
  const SurfaceCorner far = firstEdge(mesh, isFar);
  const Seams none(mesh.twin.size(), 0);
  Seams seams = none;
  seams[far] = seams[mesh.twin[far]] = 1;
  const Seams alone = seams;
  CHECK(addImages(mesh, mirror, none, seams, {}).empty());
  CHECK(seams == alone);
}

TEST_CASE("seams of a symmetric mesh are symmetric where that is asked for",
          "[seams][symmetry][quality]") {
  const PolygonMesh mesh = symmetricAnimal();
  for (const PolygonMesh& m : {mesh, transformed(mesh, 7, {1, 2, 3}), renumbered(mesh, 5).mesh}) {
    const Cuttable c(m);
    const Mirror mirror = findMirror(c.seamMesh);
    REQUIRE(mirror);
    SeamReport report;
    const Seams always = findSeams(c.seamMesh, {}, with(SymmetricSeams::Always), &report);
    CHECK(mirroredShare(c.seamMesh, mirror, always) > 0.9);
    CHECK(report.stretch <= 1.02);
    const CutSurface s = cutAlong(c.seamMesh, always);
    for (const CutSurface::Chart& chart : s.charts) CHECK(chart.isDisk());
    SeamReport shortest, chosen;
    const Seams never = findSeams(c.seamMesh, {}, with(SymmetricSeams::Never), &shortest);
    CHECK(mirroredShare(c.seamMesh, mirror, never) < 0.9);
    findSeams(c.seamMesh, {}, with(SymmetricSeams::Auto), &chosen);
    CHECK(chosen.seamLength <= 1.1 * shortest.seamLength);
    CHECK(chosen.charts <= shortest.charts + 1);
  }
}

TEST_CASE("noise and a part on one side only leave seams symmetric", "[seams][symmetry][quality]") {
  const PolygonMesh mesh = symmetricAnimal();
  for (const PolygonMesh& m : {shaken(mesh, 1e-4), withKnob(mesh)}) {
    const Cuttable c(m);
    const Mirror mirror = findMirror(c.seamMesh);
    REQUIRE(mirror);
    const Seams always = findSeams(c.seamMesh, {}, with(SymmetricSeams::Always), nullptr);
    CHECK(mirroredShare(c.seamMesh, mirror, always) > 0.95);
    CHECK(shareWithImage(c.seamMesh, mirror, always) > 0.8);
  }
}

TEST_CASE("what is given stays, and nothing symmetric is sought beside it", "[seams][symmetry]") {
  const Cuttable c(symmetricAnimal());
  Seams given(c.seamMesh.twin.size(), 0);
  given.front() = 1;
  const Seams always = findSeams(c.seamMesh, given, with(SymmetricSeams::Always), nullptr);
  CHECK(always.front());
  CHECK(always == findSeams(c.seamMesh, given, with(SymmetricSeams::Never), nullptr));
}
