#include "unwrap/blocks.h"

#include <cmath>

#include "catch.h"
#include "support/copies.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"
#include "support/squares.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// For each part of a mesh; no seams are cut.
std::vector<bool> blocksOf(const PolygonMesh& mesh) {
  const Cuttable c(mesh);
  const CutSurface parts = cutAlong(c.seamMesh, Seams(c.surface.table.twin.size(), 0));
  std::vector<bool> out;
  for (const std::uint8_t is : areBlocks(c.seamMesh, parts)) out.push_back(is != 0);
  return out;
}

/// x grows with z, by the given angle.
PolygonMesh leaning(PolygonMesh mesh, double angle) {
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    mesh.positions[3 * v] += std::tan(angle) * mesh.positions[3 * v + 2];
  return mesh;
}

PolygonMesh turned(PolygonMesh mesh, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    double* p = &mesh.positions[3 * v];
    const double x = c * p[0] - s * p[1], y = s * p[0] + c * p[1];
    p[0] = x;
    p[1] = c * y - s * p[2];
    p[2] = s * y + c * p[2];
  }
  return mesh;
}

}  // namespace

TEST_CASE("steps are blocks however they stand, round and leaning surfaces are not", "[unwrap]") {
  for (const double angle : {0.0, 0.4, 1.3}) {
    PolygonMesh mesh = turned(stairs(5), angle);
    append(mesh, transformed(torus(12, 8), 1, {40, 0, 0}));
    CHECK(blocksOf(mesh) == std::vector<bool>{true, false});
  }
  CHECK(blocksOf(leaning(stairs(5), 1e-3)) == std::vector<bool>{true});
  CHECK(blocksOf(leaning(stairs(5), 0.05)) == std::vector<bool>{false});
}

TEST_CASE("a thousandth of the surface may be as it likes", "[unwrap]") {
  for (const double height : {0.005, 0.5}) {
    PolygonMesh mesh = squares(20, 20, [](auto, auto) { return true; });
    mesh.positions[3 * 220 + 2] = height;  // a vertex inside, with six triangles
    CHECK(blocksOf(mesh) == std::vector<bool>{height < 0.01});
  }
  // The same in a plane that is forty times as large.
  PolygonMesh large = squares(125, 125, [](auto, auto) { return true; });
  large.positions[3 * (126 * 60 + 60) + 2] = 0.5;
  CHECK(blocksOf(large) == std::vector<bool>{true});
}
