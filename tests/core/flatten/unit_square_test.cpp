#include "abflat/unit_square.h"

#include <algorithm>
#include <cmath>

#include "abflat/flatten.h"
#include "catch.h"
#include "check/distortion.h"
#include "check/validity.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

double width(const std::vector<double>& uv, std::size_t axis) {
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = axis; i < uv.size(); i += 2) {
    low = std::min(low, uv[i]);
    high = std::max(high, uv[i]);
  }
  return high - low;
}

}  // namespace

TEST_CASE("a layout in the unit square has its shape, and its report holds for its numbers") {
  for (const double scale : {1e-250, 1e-9, 1.0, 339.0, 1e250}) {
    const PolygonMesh mesh = transformed(bumpyGrid(12, 5, 0.7, 5), scale, {0, 0, 0});
    FlattenResult r = flatten(mesh, {}).value();
    const double proportion = width(r.uv, 0) / width(r.uv, 1);
    INFO(scale);
    REQUIRE(r.report.valid);
    fitUnitSquare(mesh, r);
    CHECK(*std::min_element(r.uv.begin(), r.uv.end()) == 0);
    CHECK(*std::max_element(r.uv.begin(), r.uv.end()) == 1);
    CHECK(width(r.uv, 0) / width(r.uv, 1) == Approx(proportion));

    const ChartReport& c = r.report.charts.front();
    const DiskChart chart = chartOf(mesh);
    const Distortion d = measureDistortion(chart, r.uv);
    const Validity v = checkValidity(chart, r.uv);
    CHECK(r.report.valid);
    CHECK(v.valid());
    CHECK(c.maxBoundaryAngle == v.maxBoundaryAngle);
    CHECK(c.angularDistortion == Approx(d.angular));
    CHECK(c.lengthDistortion == Approx(d.length));
    CHECK(c.symmetricDirichlet == Approx(d.symmetricDirichlet));
  }
}

TEST_CASE("a layout without extent stays as it is") {
  const PolygonMesh mesh = bumpyGrid(3, 3, 0.4, 1);
  FlattenResult r = flatten(mesh, {}).value();
  std::fill(r.uv.begin(), r.uv.end(), 7.0);
  fitUnitSquare(mesh, r);
  CHECK(std::all_of(r.uv.begin(), r.uv.end(), [](double x) { return x == 7; }));
  CHECK_FALSE(r.report.valid);
}
