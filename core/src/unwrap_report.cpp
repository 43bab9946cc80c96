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
          {"handleLoops", s.handleLoops},
          {"handleLength", s.handleLength},
          {"filledHoles", s.filledHoles}};
}

Json chartJson(const UnwrapChart& c) {
  return {{"faces", c.faces},
          {"firstFace", c.firstFace},
          {"boundaryVertices", c.boundaryVertices},
          {"filledHoles", c.filledHoles},
          {"area", c.area},
          {"solver", c.solver},
          {"fixed", c.fixed},
          {"iterations", c.iterations},
          {"angularDistortion", c.angularDistortion},
          {"quasiConformal", {{"mean", c.quasiConformalMean}, {"max", c.quasiConformalMax}}},
          {"symmetricDirichlet", c.symmetricDirichlet},
          {"pins", pinsJson(c.pins)},
          {"straight", straightJson(c.straight)},
          {"fallbacks", c.fallbacks},
          {"problem", c.problem},
          {"valid", c.valid}};
}

Json stagesJson(const UnwrapStages& s) {
  return {{"read", s.read}, {"surface", s.surface}, {"seams", s.seams}, {"solve", s.solve},
          {"pack", s.pack}, {"check", s.check},     {"write", s.write}};
}

Json timingsJson(const UnwrapTimings& t) {
  Json out = stagesJson(t);
  out["total"] = t.total;
  return out;
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
        {"tiles", report.atlas.tiles},
        {"utilization", report.atlas.utilization},
        {"texelDensity", report.atlas.texelDensity}}},
      {"valid", report.valid},
      {"timings", timingsJson(report.timings)},
      {"peakMemory", stagesJson(report.peakMemory)},
  };
  if (!report.error.ok()) out["error"] = errorJson(report.error);
  return jsonText(out);
}

}  // namespace abflat
