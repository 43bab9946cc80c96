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

double areaOnMesh(const PolygonMesh& mesh, const UnwrapResult& r, std::size_t triangle) {
  const auto at = [&](std::size_t k) {
    return &mesh.positions[3 * std::size_t{r.vertexMap[r.triangles[3 * triangle + k]]}];
  };
  double a[3], b[3];
  for (int d = 0; d < 3; ++d) {
    a[d] = at(1)[d] - at(0)[d];
    b[d] = at(2)[d] - at(0)[d];
  }
  const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2],
               z = a[0] * b[1] - a[1] * b[0];
  return std::sqrt(x * x + y * y + z * z) / 2;
}

double areaInAtlas(const UnwrapResult& r, std::size_t triangle) {
  const auto at = [&](std::size_t k) {
    return &r.uv[2 * std::size_t{r.vertexUv[r.triangles[3 * triangle + k]]}];
  };
  const double a[] = {at(1)[0] - at(0)[0], at(1)[1] - at(0)[1]};
  const double b[] = {at(2)[0] - at(0)[0], at(2)[1] - at(0)[1]};
  return (a[0] * b[1] - a[1] * b[0]) / 2;
}

/// Per chart, the root of its area in the atlas over that on the mesh.
std::vector<double> densities(const PolygonMesh& mesh, const UnwrapResult& r) {
  std::vector<double> flat(r.report.charts.size(), 0), solid(flat);
  for (std::size_t f = 0; f < r.chartOfTriangle.size(); ++f) {
    if (r.chartOfTriangle[f] == kNoChart) continue;
    flat[r.chartOfTriangle[f]] += areaInAtlas(r, f);
    solid[r.chartOfTriangle[f]] += areaOnMesh(mesh, r, f);
  }
  for (std::size_t i = 0; i < flat.size(); ++i) flat[i] = std::sqrt(flat[i] / solid[i]);
  return flat;
}

/// Densities for which chart i asks for `ofChart[i]`.
std::vector<double> asked(const UnwrapResult& r, const std::vector<double>& ofChart) {
  std::vector<double> out;
  for (const std::uint32_t chart : r.chartOfFace) out.push_back(ofChart[chart]);
  return out;
}

/// The same seams and charts once more.
UnwrapOptions sameCharts(const UnwrapResult& first, UnwrapOptions options = severalCharts()) {
  options.seams.isAuto = false;
  options.seams.edges = first.seams;
  options.reuse.known = knownLayout(first);
  options.minUtilization = 0;
  return options;
}

/// 1, 2, 1/2, 1, ...
std::vector<double> mixed(std::size_t charts) {
  std::vector<double> out;
  for (std::size_t i = 0; i < charts; ++i) out.push_back(i % 3 == 1 ? 2 : i % 3 == 2 ? 0.5 : 1);
  return out;
}

}  // namespace

TEST_CASE("charts get the texel density that their faces ask for", "[density]") {
  const PolygonMesh mesh = torus(24, 16);
  const UnwrapResult first = unwrapped(mesh, severalCharts());
  const std::size_t charts = first.report.charts.size();
  REQUIRE(charts >= 3);
  UnwrapOptions options = sameCharts(first);
  options.faceDensities = asked(first, mixed(charts));
  for (const double density : {kAutoTexelDensity, 8.0}) {
    options.texelDensity = density;
    const UnwrapResult second = unwrapped(mesh, options);
    REQUIRE(second.report.charts.size() == charts);
    const std::vector<double> got = densities(mesh, second);
    for (std::size_t i = 0; i < charts; ++i) {
      CHECK(got[i] * second.report.atlas.resolution ==
            Approx(mixed(charts)[i] * second.report.atlas.texelDensity).epsilon(1e-6));
      CHECK(second.report.charts[i].solver == Solver::Known);
    }
  }
}

TEST_CASE("a density of 1 everywhere changes nothing", "[density]") {
  const PolygonMesh mesh = torus(24, 16);
  UnwrapOptions options = severalCharts();
  const UnwrapResult plain = unwrapped(mesh, options);
  options.faceDensities.assign(mesh.faceCount(), 1);
  const UnwrapResult same = unwrapped(mesh, options);
  CHECK(plain.uv == same.uv);
  CHECK(plain.seams.size() == same.seams.size());
}

TEST_CASE("the same density everywhere gives the same sizes", "[density]") {
  const PolygonMesh mesh = torus(24, 16);
  const UnwrapResult plain = unwrapped(mesh, severalCharts());
  UnwrapOptions options = sameCharts(plain);
  const UnwrapResult one = unwrapped(mesh, options);
  options.faceDensities.assign(mesh.faceCount(), 4);
  const UnwrapResult four = unwrapped(mesh, options);
  CHECK(four.report.atlas.utilization == Approx(one.report.atlas.utilization).epsilon(0.02));
  const std::vector<double> got = densities(mesh, four);
  for (const double d : got) CHECK(d == Approx(got.front()).epsilon(1e-6));
}

TEST_CASE("a chart with different faces gets their texels together", "[density]") {
  const PolygonMesh mesh = bumpyGrid(8, 8, 0, 1);
  UnwrapOptions options = severalCharts();
  options.faceDensities.assign(mesh.faceCount(), 1);
  const UnwrapResult plain = unwrapped(mesh, options);
  REQUIRE(plain.report.charts.size() == 1);
  // In one chart only the mean counts, so it is the same atlas at another density.
  for (std::size_t f = 0; f < mesh.faceCount() / 2; ++f) options.faceDensities[f] = 3;
  const UnwrapResult mean = unwrapped(mesh, options);
  const double ratio = plain.report.atlas.texelDensity / mean.report.atlas.texelDensity;
  double area = 0, texels = 0;
  for (std::size_t f = 0; f < plain.chartOfTriangle.size(); ++f) {
    // Two triangles a quad, or as many as faces.
    const std::size_t face = f * mesh.faceCount() / plain.chartOfTriangle.size();
    const double d = options.faceDensities[face], part = areaOnMesh(mesh, plain, f);
    area += part;
    texels += part * d * d;
  }
  CHECK(ratio == Approx(std::sqrt(texels / area)).epsilon(0.01));
}

TEST_CASE("charts beside those that stay get their own density", "[density]") {
  const PolygonMesh mesh = torus(24, 16);
  const UnwrapResult first = unwrapped(mesh, severalCharts());
  std::vector<double> ofChart(first.report.charts.size(), 1);
  ofChart[0] = 0.5;
  UnwrapOptions options = sameCharts(first);
  options.faceDensities = asked(first, ofChart);
  for (std::uint32_t i = 1; i < ofChart.size(); ++i) options.reuse.fixedCharts.push_back(i);
  options.reuse.keepsPlaces = false;
  const UnwrapResult second = unwrapped(mesh, options);
  const std::vector<double> before = densities(mesh, first), now = densities(mesh, second);
  for (std::size_t i = 1; i < ofChart.size(); ++i) CHECK(now[i] == Approx(before[i]));
  CHECK(now[0] * second.report.atlas.resolution ==
        Approx(0.5 * second.report.atlas.texelDensity).epsilon(1e-6));
}

TEST_CASE("charts that are cut for packing keep their density", "[density]") {
  int cuts = 0;
  for (const PolygonMesh& mesh : {torus(48, 12), torus(60, 10), torus(36, 16)}) {
    UnwrapOptions options = severalCharts();
    const UnwrapResult first = unwrapped(mesh, options);
    std::vector<double> ofChart(first.report.charts.size(), 1);
    ofChart[0] = 2;
    options.faceDensities = asked(first, ofChart);
    options.seams.edges = first.seams;
    options.seams.isAuto = true;
    options.minUtilization = 0.9;
    const UnwrapResult cut = unwrapped(mesh, options);
    cuts += cut.report.atlas.packingCuts;
    const std::vector<double> got = densities(mesh, cut);
    for (std::size_t f = 0; f < cut.chartOfFace.size(); ++f)
      CHECK(got[cut.chartOfFace[f]] * cut.report.atlas.resolution ==
            Approx(options.faceDensities[f] * cut.report.atlas.texelDensity).epsilon(1e-6));
  }
  CHECK(cuts > 0);
}

TEST_CASE("densities that make no sense are refused", "[density]") {
  const PolygonMesh mesh = torus(8, 6);
  const auto said = [&](std::vector<double> densities) {
    UnwrapOptions options = severalCharts();
    options.faceDensities = std::move(densities);
    const Status status = unwrap(mesh, options).status();
    CHECK(status.code == StatusCode::InvalidOption);
    return status.message;
  };
  CHECK(said({1, 2}) == "there are 2 face densities for " + std::to_string(mesh.faceCount()) +
                            " faces. Give one per face, or none");
  for (const double wrong : {0.0, -1.0, 1e4, double(NAN)}) {
    std::vector<double> densities(mesh.faceCount(), 1);
    densities[3] = wrong;
    CHECK(said(densities).find("the density of face 3 must be ") == 0);
  }
}
