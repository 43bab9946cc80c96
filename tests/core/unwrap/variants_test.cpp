#include "unwrap/variants.h"

#include <utility>

#include "catch.h"
#include "mesh/surface.h"
#include "mesh/welded_mesh.h"
#include "seam/vary_costs.h"
#include "support/closed_meshes.h"
#include "support/copies.h"
#include "support/meshes.h"
#include "unwrap/cut_open.h"
#include "unwrap/layouts.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Cuts and flattens a mesh in several ways.
class Searches {
 public:
  explicit Searches(const PolygonMesh& mesh)
      : welded_(weld(mesh, true)), surface_(buildSurface(welded_.mesh)) {
    asked_.seams.resize(surface_.table.twin.size(), 0);
    options_.symmetricSeams = SymmetricSeams::Never;
  }

  FlatCut find(int costs, const OpenSurface* before = nullptr) {
    const FixedTriangles fixed;
    SeamSummary summary;
    FlatCut out;
    SeamVariant variant;
    variant.costs = costs;
    variant.before = before;
    out.open =
        cutOpen({welded_, 1, surface_, fixed}, asked_, variant, options_, pool_, {}, summary);
    out.charts.set = chartsOf(welded_, out.open);
    out.charts.flat.resize(out.charts.set.size());
    const IdVector<ChartId, ChartConstraints> constraints(out.charts.set.size());
    flattenAll(constraints, options_, pool_, {}, out.charts);
    return out;
  }

  double cost(FlatCut& cut) const { return costOf(options_, cut); }
  bool isHopeless(FlatCut& best, FlatCut& other) const {
    return abflat::isHopeless(options_, best, other);
  }
  bool take(FlatCut& best, FlatCut& other) const {
    return takeBetter(welded_, options_, best, other);
  }

 private:
  WeldedMesh welded_;
  Surface surface_;
  AskedCuts asked_;
  UnwrapOptions options_;
  ThreadPool pool_{1};
};

/// A closed surface in bumps that does not unroll.
PolygonMesh bumpyTorus(unsigned seed) {
  PolygonMesh mesh = torus(18, 12);
  const PolygonMesh bumps = bumpyGrid(18, 12, 0.4, seed);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.positions[i] += 0.3 * bumps.positions[(i + 2) % mesh.positions.size()] / 18;
  return mesh;
}

}  // namespace

TEST_CASE("of several searches, each component keeps the cheapest", "[unwrap]") {
  PolygonMesh mesh = bumpyTorus(1);
  for (const unsigned seed : {2u, 3u})
    append(mesh, transformed(bumpyTorus(seed), 1, {8.0 * seed, 0, 0}));
  Searches searches(mesh);
  FlatCut best = searches.find(0);
  const IdVector<SurfaceVertex, std::uint32_t> ranks = best.open.eliminationRanks;
  int replaced = 0;
  for (int k = 1; k <= 6; ++k) {
    FlatCut other = searches.find(k, &best.open);
    const double before = searches.cost(best), offered = searches.cost(other);
    const bool isAny = searches.take(best, other);
    replaced += isAny;
    const double now = searches.cost(best);
    CHECK(now <= before * (1 + 1e-9));
    CHECK(now <= offered * (1 + 1e-9));
    CHECK(isAny == (now < before));
    for (const FlatChart& chart : best.charts.flat) {
      CHECK(chart.problem.empty());
      CHECK_FALSE(chart.unpacked.empty());
    }
    CHECK(best.open.eliminationRanks.size() == ranks.size());
  }
  CHECK(replaced > 0);
}

TEST_CASE("what unrolls is not cut in another way unless seams get clearly shorter", "[unwrap]") {
  Searches searches(cylinder(16, 4));
  FlatCut best = searches.find(0), other = searches.find(1, &best.open);
  const double before = searches.cost(best);
  CHECK_FALSE(searches.take(best, other));
  CHECK(searches.cost(best) == before);
}

TEST_CASE("later searches cut plates out if the first did", "[unwrap]") {
  Searches searches(grille(5, 0.5));
  FlatCut first = searches.find(0);
  REQUIRE_FALSE(first.open.plates.empty());
  const FlatCut other = searches.find(1, &first.open);
  CHECK(other.open.plates == first.open.plates);
  CHECK(other.open.mesh.twin.size() == first.open.mesh.twin.size());
  CHECK(other.charts.set.size() <= first.charts.set.size());
  first.open.plates.clear();
  CHECK(searches.find(1, &first.open).open.plates.empty());
  CHECK(Searches(bumpyTorus(1)).find(0).open.plates.empty());
}

TEST_CASE("seams that cost more than others with all their charts are hopeless", "[unwrap]") {
  Searches searches(bumpyTorus(1));
  FlatCut best = searches.find(0), other = searches.find(1, &best.open);
  CHECK_FALSE(searches.isHopeless(best, best));
  if (searches.isHopeless(best, other)) CHECK_FALSE(searches.cost(other) < searches.cost(best));
  for (const SurfaceCorner h : other.open.seams.ids())
    other.open.seams[h] = other.open.mesh.twin[h].exists();
  CHECK(searches.isHopeless(best, other));
  CHECK_FALSE(searches.isHopeless(other, best));
}

TEST_CASE("the larger a surface, the fewer searches", "[unwrap]") {
  CHECK(variantsWorth(0, 0).empty());
  CHECK(variantsWorth(100, 0).size() > variantsWorth(6000, 0).size());
  CHECK(variantsWorth(20'000, 0).front().bound == SeamBound::Tighter);
  CHECK(variantsWorth(50'000, 0.001).empty());
  CHECK(variantsWorth(50'000, 0.1).size() == kFrontVariants);
  CHECK(variantsWorth(50'000, 0.1, true).size() == kFrontVariants + 1);
  CHECK(variantsWorth(1'000'000, 0.1, true).empty());
}
