#include "unwrap/right_angled.h"

#include <cmath>

#include "catch.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Of a disk in the plane z = 0, turned and moved there.
RightAngled ofFlat(const PolygonMesh& mesh, double angle) {
  const Cuttable c(mesh);
  const ChartSet set = makeCharts(c.mesh, filledTable(c.seamMesh, c.surface.fans.inputVertex,
                                                      Seams(c.surface.table.twin.size(), 0)));
  REQUIRE(set.size() == 1);
  const ChartTopology topology = set.topology(ChartId(0));
  std::vector<double> uv;
  for (const InputVertex v : topology.inputVertex) {
    const double x = mesh.positions[3 * v], y = mesh.positions[3 * v + 1];
    uv.push_back(std::cos(angle) * x - std::sin(angle) * y + 2);
    uv.push_back(std::sin(angle) * x + std::cos(angle) * y - 3);
  }
  return rightAngled(topology, uv);
}

}  // namespace

TEST_CASE("the outline of a square is right-angled at any angle, that of a disc never",
          "[unwrap]") {
  const PolygonMesh square = cone(4, 0);
  for (const double angle : {0.0, 0.3, 0.9}) {
    const RightAngled of = ofFlat(square, angle), disc = ofFlat(cone(16, 0), angle);
    CHECK(of.length > 0);
    CHECK(std::abs(of.along - ofFlat(square, 0).length) < 1e-12 * of.length);
    CHECK(of.share() > 1 - 1e-12);
    CHECK(disc.length > 0);
    CHECK(disc.share() < 1e-12);
  }
  CHECK(RightAngled().share() == 1);
}
