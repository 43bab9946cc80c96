#include <algorithm>
#include <limits>

#include "abflat/draw.h"
#include "abflat/flatten.h"
#include "abflat/samples.h"
#include "catch.h"

using namespace abflat;

namespace {

/// Two triangles on the edge 0-1, with their apexes at the given heights above and below it.
FlattenResult kite(double above, double below) {
  FlattenResult out;
  out.uv = {-1, 0, 1, 0, 0, above, 0, -below};
  out.triangles = {0, 1, 2, 1, 0, 3};
  out.report.charts.emplace_back();
  out.report.charts[0].valid = true;
  return out;
}

bool contains(const Drawing& drawing, const char* text) {
  return drawing.body.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("edges that are not Delaunay are counted", "[draw]") {
  LayoutDrawingOptions options;
  options.marksNonDelaunay = true;
  CHECK(contains(drawLayout(kite(2, 2), options), "every edge is Delaunay"));
  CHECK(contains(drawLayout(kite(0.5, 0.5), options), "1 edge is not Delaunay"));
  // The four corners of a square lie on one circle, so both diagonals are Delaunay.
  CHECK(contains(drawLayout(kite(1, 1), options), "every edge is Delaunay"));
  options.marksNonDelaunay = false;
  CHECK_FALSE(contains(drawLayout(kite(0.5, 0.5), options), "Delaunay"));
}

TEST_CASE("a layout that is not valid says why", "[draw]") {
  FlattenResult flat = kite(1, 1);
  CHECK(contains(drawLayout(flat, {}), ">valid<"));
  ChartReport& chart = flat.report.charts[0];
  chart.valid = false;
  chart.flippedTriangles = 1;
  chart.boundaryCrossings = 2;
  CHECK(contains(drawLayout(flat, {}), "not valid: 2 crossings, 1 flipped triangle<"));
}

TEST_CASE("flipped triangles and crossings are drawn", "[draw]") {
  const std::string plain = drawLayout(kite(1, 1), {}).body;
  CHECK(plain.find("<circle") == std::string::npos);
  CHECK(drawLayout(kite(-0.5, 1), {}).body.size() > plain.size());
  FlattenResult bow = kite(1, 1);
  bow.uv = {-1, 0, 1, 0, -1, 1, 1, 2};  // the quad 1, 2, 0, 3 crosses itself
  CHECK(contains(drawLayout(bow, {}), "<circle"));
}

TEST_CASE("coordinates that are not finite, and no coordinates at all, still make a picture",
          "[draw]") {
  FlattenResult flat = kite(1, 1);
  flat.uv[3] = std::numeric_limits<double>::quiet_NaN();
  flat.uv[4] = std::numeric_limits<double>::infinity();
  const std::string body = drawLayout(flat, {}).body;
  CHECK(body.find("nan") == std::string::npos);
  CHECK(body.find("inf") == std::string::npos);
  flat.uv.assign(8, 0);
  CHECK_FALSE(drawLayout(flat, {}).body.empty());
}

TEST_CASE("a surface is drawn with all of its faces, flat ones and extreme ones too", "[draw]") {
  // Each face closes its path once; the only other z is in font-size.
  const auto facesIn = [](const std::string& body) {
    long out = 0;
    for (std::size_t at = body.find('z'); at != std::string::npos; at = body.find('z', at + 1))
      if (body.compare(at - 1, 3, "ize") != 0) ++out;
    return out;
  };
  for (const Sample& sample : samples()) {
    const PolygonMesh mesh = sample.make(1);
    CHECK(facesIn(drawSurface(mesh, {}).body) == static_cast<long>(mesh.faceCount()));
  }
  for (const double size : {0.0, 1e-300, 1e300}) {
    const PolygonMesh mesh = makeTriangleMesh({0, 0, 0, size, 0, 0, 0, size, size}, {0, 1, 2});
    const std::string body = drawSurface(mesh, {}).body;
    CHECK(facesIn(body) == 1);
    CHECK(body.find("nan") == std::string::npos);
  }
  CHECK(facesIn(drawSurface({}, {}).body) == 0);
}

TEST_CASE("a plot stands even when values are zero, missing or not finite", "[draw]") {
  const std::vector<Curve> curves = {
      {{1, 1e-3, 0}}, {{}}, {{std::numeric_limits<double>::quiet_NaN()}}};
  const Drawing plot = drawLogPlot(curves, {"title <1>", "steps"});
  CHECK(contains(plot, "title &lt;1&gt;"));
  CHECK_FALSE(contains(plot, "nan"));
  CHECK_FALSE(drawLogPlot({}, {}).body.empty());
}
