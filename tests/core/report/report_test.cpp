#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "abflat/flatten.h"
#include "abflat/unwrap.h"
#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;
using Json = nlohmann::ordered_json;

namespace {

using Keys = std::vector<std::string>;

Keys keysOf(const Json& object) {
  Keys out;
  for (const auto& item : object.items()) out.push_back(item.key());
  return out;
}

Report reportOf(const PolygonMesh& mesh) { return flatten(mesh, FlattenOptions{}).value().report; }

Json parsed(const Report& report) { return Json::parse(reportJson(report)); }

}  // namespace

TEST_CASE("the report has its keys in their order") {
  const Json json = parsed(reportOf(bumpyGrid(6, 6, 0.3, 1)));
  CHECK(keysOf(json) ==
        Keys{"version", "input", "options", "threads", "charts", "valid", "timings"});
  CHECK(keysOf(json["input"]) == Keys{"path", "vertices", "faces", "triangles", "components",
                                      "boundaryLoops", "boundaryEdges", "genus"});
  CHECK(keysOf(json["options"]) == Keys{"t", "balance", "untangle", "linearSolver", "memory",
                                        "adjacent", "delaunay", "threads", "formulation",
                                        "precondition"});
  CHECK(keysOf(json["timings"]) ==
        Keys{"read", "connectivity", "solve", "layout", "refine", "check", "write", "total"});
  const Json& chart = json["charts"].at(0);
  CHECK(keysOf(chart) == Keys{"faces",
                              "boundaryVertices",
                              "t",
                              "bounds",
                              "solver",
                              "linearSolver",
                              "formulation",
                              "iterations",
                              "history",
                              "constraintResidual",
                              "converged",
                              "angularDistortion",
                              "lengthDistortion",
                              "quasiConformal",
                              "stretch",
                              "symmetricDirichlet",
                              "areaDistortion",
                              "degenerateTriangles",
                              "flippedTriangles",
                              "boundaryCrossings",
                              "maxBoundaryAngle",
                              "delaunay",
                              "refined",
                              "pins",
                              "straight",
                              "fallbacks",
                              "problem",
                              "valid"});
  CHECK(keysOf(chart["history"].at(0)) == Keys{"objective", "constraint", "gradient", "active",
                                               "activeEdges", "step", "reweighted",
                                               "linearIterations"});
  CHECK(keysOf(chart["quasiConformal"]) == Keys{"mean", "max", "sheared"});
  CHECK(keysOf(chart["stretch"]) == Keys{"l2", "linf"});
  CHECK(keysOf(chart["areaDistortion"]) == Keys{"min", "max"});
}

TEST_CASE("the report's numbers read back to the same doubles") {
  Report report = reportOf(bumpyGrid(6, 6, 0.3, 1));
  report.timings.total = 0.1;
  const Json json = parsed(report);
  const ChartReport& chart = report.charts.front();
  CHECK(json["charts"][0]["angularDistortion"].get<double>() == chart.angularDistortion);
  CHECK(json["charts"][0]["stretch"]["linf"].get<double>() == chart.stretchLinf);
  CHECK(json["charts"][0]["history"].size() == chart.history.size());
  CHECK(json["charts"][0]["history"].back()["objective"].get<double>() ==
        chart.history.back().objective);
  CHECK(json["input"]["vertices"].get<std::size_t>() == 49);
  CHECK(json["timings"]["total"].get<double>() == 0.1);
  CHECK(json["valid"].get<bool>());
}

TEST_CASE("numbers that are not finite become null") {
  Report report = reportOf(bumpyGrid(3, 3, 0.3, 1));
  report.charts.front().stretchLinf = std::numeric_limits<double>::infinity();
  report.charts.front().symmetricDirichlet = std::nan("");
  const Json json = parsed(report);
  CHECK(json["charts"][0]["stretch"]["linf"].is_null());
  CHECK(json["charts"][0]["symmetricDirichlet"].is_null());
}

TEST_CASE("a report without a result carries the error") {
  Report report;
  report.path = "a \"quoted\" \\ name.obj";
  report.input.faces = 12;
  report.error = {StatusCode::ClosedSurface, "closed surface"};
  const Json json = parsed(report);
  CHECK(json["input"]["path"].get<std::string>() == report.path);
  CHECK(json["input"]["faces"].get<int>() == 12);
  CHECK(json["charts"].empty());
  CHECK_FALSE(json["valid"].get<bool>());
  CHECK(keysOf(json["error"]) == Keys{"code", "message"});
  CHECK(json["error"]["code"].get<std::string>() == "ClosedSurface");
  CHECK(json["error"]["message"].get<std::string>() == "closed surface");

  for (StatusCode code : {StatusCode::ParseError, StatusCode::OutOfMemory}) {
    report.error.code = code;
    CHECK(parsed(report)["input"]["faces"].is_null());
  }
}

TEST_CASE("a path that is not UTF-8 does not spoil the report") {
  Report report;
  report.path = "caf\xe9.obj";
  CHECK(parsed(report)["input"]["path"].get<std::string>() == "caf\xef\xbf\xbd.obj");
}

TEST_CASE("inspectJson says what a mesh is and why it is not a disk") {
  const Json disk = Json::parse(inspectJson(inspect(bumpyGrid(4, 3, 0.3, 1)), "grid.obj"));
  CHECK(keysOf(disk) == Keys{"path", "vertices", "unreferencedVertices", "faces", "triangles",
                             "components", "boundaryLoops", "boundaryEdges", "nonManifoldEdges",
                             "orientationConflicts", "degenerateFaces", "eulerCharacteristic",
                             "genus", "texcoords", "normals", "smoothingGroups", "materials",
                             "disk"});
  CHECK(disk["path"].get<std::string>() == "grid.obj");
  CHECK(disk["faces"].get<int>() == 24);
  CHECK(disk["boundaryEdges"].get<int>() == 14);
  CHECK(keysOf(disk["disk"]) == Keys{"ok", "code", "message"});
  CHECK(disk["disk"]["ok"].get<bool>());

  const Json closed = Json::parse(inspectJson(inspect(torus(5, 4)), "torus.obj"));
  CHECK(closed["genus"].get<int>() == 1);
  CHECK(closed["disk"]["code"].get<std::string>() == "ClosedSurface");
  CHECK_FALSE(closed["disk"]["message"].get<std::string>().empty());
}

TEST_CASE("the report of an atlas is written like any other JSON, chart by chart", "[unwrap]") {
  UnwrapReport report = unwrap(bumpyGrid(6, 6, 0.3, 1), UnwrapOptions{}).value().report;
  report.path = "a\n  \"charts\": [].obj";
  const UnwrapChart chart = report.charts.front();
  for (const std::size_t count : {0, 1, 3}) {
    report.charts.assign(count, chart);
    for (UnwrapChart& each : report.charts) each.fallbacks = {"one\ntwo", "\"three\""};
    const std::string text = unwrapReportJson(report);
    const Json json = Json::parse(text);
    CHECK(json["charts"].size() == count);
    CHECK(json["input"]["path"] == report.path);
    CHECK(json.dump(2) + "\n" == text);
  }
}
