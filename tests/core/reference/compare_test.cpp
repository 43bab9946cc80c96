#include "abflat/compare.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "abflat/samples.h"
#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

Comparison compared(const PolygonMesh& mesh) {
  Result<Comparison> r = compare(mesh, {});
  INFO(r.status().message);
  REQUIRE(r.ok());
  return std::move(r.value());
}

std::vector<double> measuresOf(const MethodResult& m) {
  return {m.angularDistortion, m.lengthDistortion,   m.areaDistortion,
          m.areaRatioMin,      m.areaRatioMax,       m.quasiConformalMean,
          m.quasiConformalMax, m.symmetricDirichlet, static_cast<double>(m.flippedTriangles)};
}

void checkAlike(const Comparison& a, const Comparison& b) {
  REQUIRE(a.methods.size() == b.methods.size());
  for (std::size_t i = 0; i < a.methods.size(); ++i) {
    INFO(nameOf(a.methods[i].method));
    CHECK(a.methods[i].method == b.methods[i].method);
    CHECK(a.methods[i].valid == b.methods[i].valid);
    const std::vector<double> p = measuresOf(a.methods[i]), q = measuresOf(b.methods[i]);
    // An energy is flat around its minimum, so refining may end anywhere near it.
    const MethodKey method = a.methods[i].method;
    const bool isRefined = method == MethodKey::AbflatBalanced ||
                           method == MethodKey::SymmetricDirichlet || method == MethodKey::Mips;
    const double tolerance = isRefined ? 1e-3 : 1e-6;
    for (std::size_t k = 0; k < p.size(); ++k) CHECK(p[k] == Approx(q[k]).epsilon(tolerance));
  }
}

}  // namespace

TEST_CASE("every method gives a layout of the surface's area in the corner of the plane") {
  const PolygonMesh mesh = transformed(bumpyGrid(8, 6, 0.4, 1), 40, {5, 6, 7});
  const Comparison c = compared(mesh);
  REQUIRE(c.methods.size() == 10);
  std::vector<double> areas;
  for (const MethodResult& m : c.methods) {
    INFO(nameOf(m.method));
    CHECK(m.valid);
    CHECK(m.problem.empty());
    REQUIRE(m.uv.size() == 2 * c.vertexMap.size());
    double area = 0, low[2] = {INFINITY, INFINITY};
    for (std::size_t f = 0; f < c.triangles.size(); f += 3) {
      const double *p = &m.uv[2 * c.triangles[f]], *q = &m.uv[2 * c.triangles[f + 1]],
                   *r = &m.uv[2 * c.triangles[f + 2]];
      area += ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
    }
    for (std::size_t i = 0; i < m.uv.size(); ++i) low[i % 2] = std::min(low[i % 2], m.uv[i]);
    areas.push_back(area);
    CHECK(area == Approx(areas.front()));
    CHECK(low[0] == Approx(0).margin(1e-9 * std::sqrt(area)));
    CHECK(low[1] == Approx(0).margin(1e-9 * std::sqrt(area)));
  }
}

TEST_CASE("comparisons do not depend on size, place, rotation and numbering") {
  const PolygonMesh mesh = bumpyGrid(9, 6, 0.4, 2);
  const Comparison c = compared(mesh);
  checkAlike(c, compared(transformed(mesh, 3e-4, {3, 2, 1})));
  checkAlike(c, compared(renumbered(mesh, 3).mesh));
}

TEST_CASE("the abflat rows are those of flatten") {
  const PolygonMesh mesh = samples()[3].make(1);
  const Comparison c = compared(mesh);
  const double t[] = {kAutoT, 1, 2};
  for (std::size_t i = 0; i < 3; ++i) {
    FlattenOptions options;
    options.t = t[i];
    const Result<FlattenResult> flat = flatten(mesh, options);
    REQUIRE(flat.ok());
    const ChartReport& r = flat.value().report.charts.front();
    const MethodResult& m = c.methods[i];
    CHECK(m.uv == flat.value().uv);
    CHECK(m.angularDistortion == r.angularDistortion);
    CHECK(m.lengthDistortion == r.lengthDistortion);
    CHECK(m.areaRatioMax == r.areaDistortionMax);
    CHECK(m.boundaryCrossings == r.boundaryCrossings);
    CHECK(m.valid == r.valid);
    CHECK(m.problem == r.problem);
  }
}

TEST_CASE("a free abflat layout keeps angles better than every other one", "[quality]") {
  for (const Sample& sample : samples()) {
    const Comparison c = compared(sample.make(1));
    const MethodResult& free = c.methods[2];
    REQUIRE(free.method == MethodKey::AbflatFree);
    for (const MethodResult& m : c.methods) {
      INFO(sample.name << " " << nameOf(m.method));
      CHECK(free.angularDistortion <= m.angularDistortion * (1 + 1e-9));
    }
  }
}

TEST_CASE("every energy is least in the row that minimises it") {
  for (const char* name : {"hemisphere", "head"}) {
    const auto sample = std::find_if(samples().begin(), samples().end(),
                                     [&](const Sample& s) { return s.name == name; });
    const Comparison c = compared(sample->make(1));
    const auto row = [&](MethodKey key) -> const MethodResult& {
      return *std::find_if(c.methods.begin(), c.methods.end(),
                           [&](const MethodResult& m) { return m.method == key; });
    };
    INFO(name);
    for (const MethodResult& m : c.methods)
      if (m.valid)
        CHECK(row(MethodKey::SymmetricDirichlet).symmetricDirichlet <= m.symmetricDirichlet);
    // Between the two in both measures, since a balance trades one for the other.
    const double balanced = row(MethodKey::AbflatBalanced).symmetricDirichlet;
    CHECK(balanced <= row(MethodKey::AbflatAuto).symmetricDirichlet);
    CHECK(row(MethodKey::AbflatBalanced).quasiConformalMean <=
          row(MethodKey::SymmetricDirichlet).quasiConformalMean);
    CHECK(row(MethodKey::Mips).quasiConformalMean <=
          row(MethodKey::AbflatAuto).quasiConformalMean * (1 + 1e-9));
  }
}

TEST_CASE("a flat mesh keeps its areas where angles are kept, but not on a circle") {
  const Comparison flat = compared(bumpyGrid(5, 5, 0, 3));
  for (const std::size_t conformal : {std::size_t{0}, std::size_t{2}, std::size_t{9}})
    CHECK(flat.methods[conformal].areaDistortion < 1e-6);
  for (const std::size_t onCircle : {std::size_t{6}, std::size_t{7}, std::size_t{8}}) {
    const MethodResult& m = flat.methods[onCircle];
    CHECK(m.areaDistortion > 0.01);
    CHECK(m.areaDistortion <=
          std::max(std::abs(std::log(m.areaRatioMin)), std::abs(std::log(m.areaRatioMax))));
  }
}

TEST_CASE("a comparison is refused or cancelled as flattening is") {
  CHECK(compare(tetrahedron(), {}).status().code == StatusCode::ClosedSurface);
  CHECK(compare(torus(5, 4), {}).status().code == StatusCode::ClosedSurface);
  CHECK(compare({}, {}).status().code == StatusCode::EmptyMesh);
  const PolygonMesh mesh = bumpyGrid(4, 4, 0.3, 4);
  std::vector<MethodKey> stages;
  double last = 0;
  CompareOptions options;
  options.progress = [&](const Progress& p) {
    REQUIRE(p.method.has_value());
    if (stages.empty() || stages.back() != *p.method) stages.push_back(*p.method);
    CHECK(p.fraction >= last);
    CHECK(p.fraction <= 1);
    last = p.fraction;
    return true;
  };
  const Result<Comparison> whole = compare(mesh, options);
  REQUIRE(whole.ok());
  REQUIRE(stages.size() == whole.value().methods.size());
  for (std::size_t i = 0; i < stages.size(); ++i)
    CHECK(stages[i] == whole.value().methods[i].method);
  for (const MethodKey stop : stages) {
    options.progress = [&](const Progress& p) { return p.method != stop; };
    CHECK(compare(mesh, options).status().code == StatusCode::Aborted);
  }
}

TEST_CASE("the JSON has a row for every method, null for what is not finite") {
  Comparison c = compared(bumpyGrid(3, 3, 0.3, 5));
  c.methods.back().areaDistortion = INFINITY;
  c.methods.back().angularDistortion = NAN;
  const auto json = nlohmann::json::parse(compareJson(c, "a \"b\".obj"));
  CHECK(json["input"]["path"] == "a \"b\".obj");
  CHECK(json["input"]["triangles"] == 18);
  REQUIRE(json["methods"].size() == c.methods.size());
  for (std::size_t i = 0; i + 1 < c.methods.size(); ++i) {
    CHECK(json["methods"][i]["method"] == nameOf(c.methods[i].method));
    CHECK(json["methods"][i]["angularDistortion"] == c.methods[i].angularDistortion);
    CHECK(json["methods"][i]["areaRatio"]["min"] == c.methods[i].areaRatioMin);
    CHECK_FALSE(json["methods"][i].contains("uv"));
  }
  CHECK(json["methods"].back()["areaDistortion"].is_null());
  CHECK(json["methods"].back()["angularDistortion"].is_null());
}
