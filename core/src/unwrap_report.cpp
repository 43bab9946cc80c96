#include <nlohmann/json.hpp>

#include "abflat/unwrap.h"
#include "report_json.h"

namespace abflat {
namespace {

Json repairJson(const RepairReport& r) {
  return {{"mergedVertices", r.mergedVertices},
          {"collapsedFaces", r.collapsedFaces},
          {"splitFaces", r.splitFaces},
          {"duplicateFaces", r.duplicateFaces},
          {"nonManifoldEdges", r.nonManifoldEdges},
          {"orientationConflicts", r.orientationConflicts},
          {"degenerateTriangles", r.degenerateTriangles}};
}

Json seamsJson(const SeamSummary& s) {
  return {{"edges", s.edges},
          {"relativeLength", s.relativeLength},
          {"genus", s.genus},
          {"handleLoops", s.handleLoops}};
}

Json chartJson(const UnwrapChart& c) {
  return {{"faces", c.faces},
          {"firstFace", c.firstFace},
          {"boundaryVertices", c.boundaryVertices},
          {"area", c.area},
          {"solver", c.solver},
          {"iterations", c.iterations},
          {"angularDistortion", c.angularDistortion},
          {"quasiConformal", {{"mean", c.quasiConformalMean}, {"max", c.quasiConformalMax}}},
          {"symmetricDirichlet", c.symmetricDirichlet},
          {"pins", pinsJson(c.pins)},
          {"fallbacks", c.fallbacks},
          {"problem", c.problem},
          {"valid", c.valid}};
}

Json timingsJson(const UnwrapTimings& t) {
  return {{"read", t.read}, {"surface", t.surface}, {"seams", t.seams}, {"solve", t.solve},
          {"pack", t.pack}, {"check", t.check},     {"write", t.write}, {"total", t.total}};
}

}  // namespace

std::string unwrapReportJson(const UnwrapReport& report) {
  Json charts = Json::array();
  for (const UnwrapChart& chart : report.charts) charts.push_back(chartJson(chart));
  Json out = {
      {"version", ABFLAT_VERSION},
      {"input", inputJson(report.input, report.path, report.error.code)},
      {"options", optionsJson(report.options)},
      {"threads", report.threads},
      {"repair", repairJson(report.repair)},
      {"seams", seamsJson(report.seams)},
      {"charts", charts},
      {"notes", report.notes},
      {"angularDistortion", report.angularDistortion},
      {"quasiConformalMean", report.quasiConformalMean},
      {"symmetricDirichlet", report.symmetricDirichlet},
      {"atlas",
       {{"resolution", report.atlas.resolution},
        {"padding", report.atlas.padding},
        {"utilization", report.atlas.utilization},
        {"texelDensity", report.atlas.texelDensity}}},
      {"valid", report.valid},
      {"timings", timingsJson(report.timings)},
  };
  if (!report.error.ok()) out["error"] = errorJson(report.error);
  return jsonText(out);
}

}  // namespace abflat
