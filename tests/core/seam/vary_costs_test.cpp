#include "seam/vary_costs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "catch.h"
#include "samples/generators.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// By how much the costs of edges change.
std::map<Edge, double> factors(const PolygonMesh& mesh, int variant) {
  const SeamMesh before = Cuttable(mesh).seamMesh;
  SeamMesh varied = before;
  varyCosts(variant, varied);
  std::map<Edge, double> out;
  for (const SurfaceCorner h : before.corners())
    if (before.twin[h].exists())
      out[std::minmax(before.tail(h), before.head(h))] = varied.cost[h] / before.cost[h];
  return out;
}

/// Longer in one direction than in another, so that it has principal axes.
PolygonMesh hills() { return bumpyGrid(30, 18, 2, 5); }

PolygonMesh mirrored(PolygonMesh mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) mesh.positions[i] *= -1;
  for (std::size_t c = 0; c < mesh.faceVertices.size(); c += 3)
    std::swap(mesh.faceVertices[c], mesh.faceVertices[c + 1]);
  return mesh;
}

void checkAlike(const std::map<Edge, double>& a, const std::map<Edge, double>& b) {
  REQUIRE(a.size() == b.size());
  for (const auto& [edge, factor] : a) CHECK(factor == Approx(b.at(edge)).epsilon(1e-4));
}

}  // namespace

TEST_CASE("varied costs differ a little, each variant in its own way", "[seams]") {
  for (const auto& [edge, factor] : factors(hills(), 0)) CHECK(factor == 1);
  std::vector<std::map<Edge, double>> all;
  for (int k = 1; k <= kCostVariants; ++k) {
    all.push_back(factors(hills(), k));
    double least = HUGE_VAL, most = 0;
    for (const auto& [edge, factor] : all.back()) {
      least = std::min(least, factor);
      most = std::max(most, factor);
    }
    CHECK(least > 0.7);
    CHECK(most < 1.3);
    CHECK(most > least + 0.1);
    CHECK(std::count(all.begin(), all.end(), all.back()) == 1);
  }
}

TEST_CASE("varied costs are those of the shape, however it lies", "[seams]") {
  for (int k = 1; k <= kCostVariants; ++k)
    checkAlike(factors(hills(), k), factors(transformed(hills(), 3, {5, -2, 1}), k));
}

TEST_CASE("the last variants make the front dearer, and nothing else", "[seams]") {
  const SeamMesh before = Cuttable(makeHead(1)).seamMesh;
  REQUIRE(!before.dearness.empty());
  double last = 1;
  for (int k = kCostVariants + 1; k <= kCostVariants + kFrontVariants; ++k) {
    SeamMesh varied = before;
    varyCosts(k, varied);
    double most = 1;
    for (const SurfaceCorner h : before.corners()) {
      const double factor = varied.cost[h] / before.cost[h];
      CHECK(varied.plainCost(h) == Approx(before.plainCost(h)));
      CHECK((factor == 1) == (before.dearness[h] == 1));
      most = std::max(most, factor);
    }
    CHECK(most > 4 * last);
    last = most;
  }
  SeamMesh hilly = Cuttable(hills()).seamMesh;
  hilly.dearness.clear();
  const IdVector<SurfaceCorner, double> cost = hilly.cost;
  varyCosts(kCostVariants + 1, hilly);
  CHECK(hilly.cost == cost);
}

TEST_CASE("varied costs of mirror images are alike", "[seams]") {
  for (int k = 1; k <= kCostVariants; ++k)
    checkAlike(factors(hills(), k), factors(mirrored(hills()), k));
}
