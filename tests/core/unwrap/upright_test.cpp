#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "abflat/io.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

using Vector = std::array<double, 3>;

/// A box as six quads, turned about y.
PolygonMesh box(const Vector& size, double angle) {
  PolygonMesh out;
  for (unsigned k = 0; k < 8; ++k) {
    const double x = k & 1 ? size[0] : 0, y = k & 2 ? size[1] : 0, z = k & 4 ? size[2] : 0;
    out.positions.insert(out.positions.end(), {std::cos(angle) * x + std::sin(angle) * z, y,
                                               std::cos(angle) * z - std::sin(angle) * x});
  }
  out.faceVertices = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
  out.faceOffsets = {0, 4, 8, 12, 16, 20, 24};
  return out;
}

/// A wall, 3 wide and 2 high in the plane of x and y, with a window in it, as a grid of squares.
PolygonMesh wall() {
  PolygonMesh out;
  constexpr unsigned kColumns = 12, kRows = 8;
  for (unsigned j = 0; j <= kRows; ++j)
    for (unsigned i = 0; i <= kColumns; ++i)
      out.positions.insert(out.positions.end(), {0.25 * i, 0.25 * j, 0});
  out.faceOffsets = {0};
  for (unsigned j = 0; j < kRows; ++j)
    for (unsigned i = 0; i < kColumns; ++i) {
      if (i >= 2 && i < 5 && j >= 3 && j < 7) continue;
      const unsigned v = j * (kColumns + 1) + i;
      for (const unsigned corner : {v, v + 1, v + kColumns + 2, v + kColumns + 1})
        out.faceVertices.push_back(corner);
      out.faceOffsets.push_back(static_cast<std::uint32_t>(out.faceVertices.size()));
    }
  return out;
}

UnwrapOptions sharpSeams(Rotate rotate) {
  UnwrapOptions out;
  out.seams.isAuto = false;
  out.seams.sharpDegrees = 30;
  out.resolution = 512;
  out.rotate = rotate;
  return out;
}

/// A face in the atlas: how far its sides are from lying along u or v, as the largest sine, and
/// the v component of the image of a direction of the mesh, as a unit vector (0 if it points out
/// of the face).
struct Lie {
  double skewness = 0, upright = 0;
};

Lie lieOf(const PolygonMesh& mesh, const UnwrapResult& r, std::size_t face, const Vector& up) {
  Lie out;
  double along[2] = {0, 0};
  const std::size_t begin = mesh.faceOffsets[face], end = mesh.faceOffsets[face + 1];
  for (std::size_t c = begin; c < end; ++c) {
    const std::size_t d = c + 1 < end ? c + 1 : begin;
    double uv[2], height = 0, side = 0;
    for (std::size_t k = 0; k < 2; ++k)
      uv[k] = r.uv[2 * r.cornerUv[d] + k] - r.uv[2 * r.cornerUv[c] + k];
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = mesh.positions[3 * mesh.faceVertices[d] + k] -
                       mesh.positions[3 * mesh.faceVertices[c] + k];
      height += up[k] * x;
      side += x * x;
    }
    const double length = std::hypot(uv[0], uv[1]);
    out.skewness = std::max(out.skewness, std::min(std::abs(uv[0]), std::abs(uv[1])) / length);
    // Of a rectangle's sides, those that rise show where up is.
    for (std::size_t k = 0; k < 2; ++k) along[k] += height / std::sqrt(side) * uv[k] / length;
  }
  const double length = std::hypot(along[0], along[1]);
  out.upright = length > 0.1 ? along[1] / length : 0;
  return out;
}

/// The v component of the image of up in all faces that stand, at least and at most.
std::pair<double, double> uprightness(const PolygonMesh& mesh, const UnwrapResult& r,
                                      const Vector& up) {
  double least = 1, most = -1;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const Lie lie = lieOf(mesh, r, f, up);
    CHECK(lie.skewness < 1e-6);
    if (lie.upright == 0) continue;
    least = std::min(least, lie.upright);
    most = std::max(most, lie.upright);
  }
  return {least, most};
}

}  // namespace

TEST_CASE("the sides of a box lie level and upright, however it is turned about its axis") {
  for (const double angle : {0.0, 0.3, 1.1, 2.5}) {
    const PolygonMesh mesh = box({3, 2, 1}, angle);
    const UnwrapResult none = unwrapped(mesh, sharpSeams(Rotate::None));
    CHECK(none.report.charts.size() == 6);
    CHECK(uprightness(mesh, none, {0, 1, 0}).first > 1 - 1e-9);
    // Quarter turns may pack tighter, so that some point sideways.
    for (const Rotate rotate : {Rotate::Quarter, Rotate::Free})
      uprightness(mesh, unwrapped(mesh, sharpSeams(rotate)), {0, 1, 0});
  }
}

TEST_CASE("the axis that points up can be named; STL files have z") {
  UnwrapOptions options = sharpSeams(Rotate::None);
  PolygonMesh mesh = box({3, 2, 1}, 0);
  options.up = Up::Z;
  CHECK(uprightness(mesh, unwrapped(mesh, options), {0, 0, 1}).first > 1 - 1e-9);
  options.up = Up::Auto;
  mesh.isZUp = true;
  CHECK(uprightness(mesh, unwrapped(mesh, options), {0, 0, 1}).first > 1 - 1e-9);
  options.up = Up::Y;
  CHECK(uprightness(mesh, unwrapped(mesh, options), {0, 1, 0}).first > 1 - 1e-9);
  const char* text =
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
      "vertex 0 1 0\nendloop\nendfacet\nendsolid\n";
  CHECK(readMesh(text, MeshFormat::Stl, "a.stl").value().isZUp);
  CHECK_FALSE(
      readMesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", MeshFormat::Obj, "a.obj").value().isZUp);
}

TEST_CASE("a wall with a window stands upright where that costs no texels") {
  const PolygonMesh mesh = wall();
  for (const Rotate rotate : {Rotate::None, Rotate::Quarter, Rotate::Free}) {
    UnwrapOptions options = sharpSeams(rotate);
    options.minUtilization = 0;
    const UnwrapResult r = unwrapped(mesh, options);
    CHECK(r.report.charts.size() == 1);
    CHECK(uprightness(mesh, r, {0, 1, 0}).first > 1 - 1e-9);
  }
}

TEST_CASE("charts are turned only by what rotate allows") {
  // All corners of the mesh are in the same places of both tables.
  const PolygonMesh mesh = transformed(bumpyGrid(12, 9, 0.7, 3), 1, {0, 0, 0});
  UnwrapOptions options = severalCharts();
  options.minUtilization = 0;
  options.rotate = Rotate::None;
  const UnwrapResult none = unwrapped(mesh, options);
  options.rotate = Rotate::Quarter;
  const UnwrapResult quarter = unwrapped(mesh, options);
  REQUIRE(none.cornerUv.size() == quarter.cornerUv.size());
  std::size_t turned = 0;
  for (std::size_t t = 0; t < none.triangleCorners.size(); t += 3) {
    double sides[2][2];
    const UnwrapResult* results[] = {&none, &quarter};
    for (std::size_t i = 0; i < 2; ++i) {
      const UnwrapResult& r = *results[i];
      const double* a = &r.uv[2 * r.cornerUv[none.triangleCorners[t]]];
      const double* b = &r.uv[2 * r.cornerUv[none.triangleCorners[t + 1]]];
      for (std::size_t k = 0; k < 2; ++k) sides[i][k] = b[k] - a[k];
    }
    const double dot = sides[0][0] * sides[1][0] + sides[0][1] * sides[1][1];
    const double cross = sides[0][0] * sides[1][1] - sides[0][1] * sides[1][0];
    CHECK(std::min(std::abs(dot), std::abs(cross)) <= 1e-9 * std::hypot(dot, cross));
    turned += !(dot > std::abs(cross));
  }
  CHECK(turned < none.triangleCorners.size() / 3);
}

TEST_CASE("islands that are kept are not turned") {
  PolygonMesh mesh = box({3, 2, 1}, 0.4);
  const UnwrapResult before = unwrapped(mesh, sharpSeams(Rotate::Quarter));
  mesh.texcoords = before.uv;
  mesh.faceTexcoords = before.cornerUv;
  // Upside down.
  for (double& x : mesh.texcoords) x = 1 - x;
  UnwrapOptions options = sharpSeams(Rotate::Free);
  options.reuse.fixedFaces = {0, 2};
  const UnwrapResult after = unwrapped(mesh, options);
  for (const std::size_t f : {0, 2})
    for (std::size_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c)
      for (std::size_t k = 0; k < 2; ++k)
        CHECK(after.uv[2 * after.cornerUv[c] + k] == mesh.texcoords[2 * mesh.faceTexcoords[c] + k]);
}
