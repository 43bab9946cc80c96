#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

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
          {"refined", refinedJson(c.refined)},
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

/// Adds them as jsonText has the elements of an array that is one level deep. There may be as many
/// charts as faces: only one at a time is a tree of objects.
void addCharts(const std::vector<UnwrapChart>& charts, std::string& out) {
  for (std::size_t i = 0; i < charts.size(); ++i) {
    std::string text = "\n" + jsonText(chartJson(charts[i]));
    text.back() = ',';
    if (i + 1 == charts.size()) text.pop_back();
    for (const char c : text) {
      out += c;
      if (c == '\n') out += "    ";
    }
    if (i == 0) out.reserve(out.size() + charts.size() * (text.size() + text.size() / 2));
  }
  out += "\n  ";
}

}  // namespace

std::string unwrapReportJson(const UnwrapReport& report) {
  Json out = {
      {"version", ABFLAT_VERSION},
      {"input", inputJson(report.input, report.path, report.error.code)},
      {"options", optionsJson(report.options)},
      {"threads", report.threads},
      {"repair", repairJson(report.repair)},
      {"seams", seamsJson(report.seams)},
      {"charts", Json::array()},
      {"notes", report.notes},
      {"angularDistortion", report.angularDistortion},
      {"quasiConformalMean", report.quasiConformalMean},
      {"symmetricDirichlet", report.symmetricDirichlet},
      {"atlas",
       {{"resolution", report.atlas.resolution},
        {"padding", report.atlas.padding},
        {"tiles", report.atlas.tiles},
        {"utilization", report.atlas.utilization},
        {"texelDensity", report.atlas.texelDensity},
        {"packingCuts", report.atlas.packingCuts},
        {"packingCutLength", report.atlas.packingCutLength},
        {"uncutTexelDensity", report.atlas.uncutTexelDensity}}},
      {"valid", report.valid},
      {"timings", timingsJson(report.timings)},
      {"peakMemory", stagesJson(report.peakMemory)},
  };
  if (!report.error.ok()) out["error"] = errorJson(report.error);
  std::string text = jsonText(out);
  if (report.charts.empty()) return text;
  // Nothing before reads like that: quotes within texts are escaped.
  const std::string_view key = "\n  \"charts\": [";
  const std::size_t at = text.find(key) + key.size();
  const std::string rest = text.substr(at);
  text.erase(at);
  addCharts(report.charts, text);
  return text += rest;
}

}  // namespace abflat
