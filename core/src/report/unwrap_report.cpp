#include <string>
#include <vector>

#include "abflat/unwrap.h"
#include "report/report_json.h"

namespace abflat {
namespace {

void writeRepair(JsonWriter& json, const RepairReport& r) {
  json.object("repair");
  json.field("mergedVertices", r.mergedVertices);
  json.field("collapsedFaces", r.collapsedFaces);
  json.field("splitFaces", r.splitFaces);
  json.field("duplicateFaces", r.duplicateFaces);
  json.field("nonManifoldEdges", r.nonManifoldEdges);
  json.field("orientationConflicts", r.orientationConflicts);
  json.field("degenerateTriangles", r.degenerateTriangles);
  json.end();
}

void writeSeams(JsonWriter& json, const SeamSummary& s) {
  json.object("seams");
  json.field("edges", s.edges);
  json.field("relativeLength", s.relativeLength);
  json.field("genus", s.genus);
  json.field("handleLoops", s.handleLoops);
  json.field("handleLength", s.handleLength);
  json.field("filledHoles", s.filledHoles);
  json.end();
}

void writeChart(JsonWriter& json, const UnwrapChart& c) {
  json.object();
  json.field("faces", c.faces);
  json.field("firstFace", c.firstFace);
  json.field("boundaryVertices", c.boundaryVertices);
  json.field("filledHoles", c.filledHoles);
  json.field("area", c.area);
  json.field("solver", nameOf(c.solver));
  json.field("fixed", c.fixed);
  json.field("iterations", c.iterations);
  json.field("angularDistortion", c.angularDistortion);
  writeQuasiConformal(json, c.quasiConformalMean, c.quasiConformalMax);
  json.field("symmetricDirichlet", c.symmetricDirichlet);
  writeRefined(json, c.refined);
  writePins(json, c.pins);
  writeStraight(json, c.straight);
  json.field("fallbacks", c.fallbacks);
  json.field("problem", c.problem);
  json.field("valid", c.valid);
  json.end();
}

void writeAtlas(JsonWriter& json, const AtlasReport& a) {
  json.object("atlas");
  json.field("resolution", a.resolution);
  json.field("padding", a.padding);
  json.field("tiles", a.tiles);
  json.field("utilization", a.utilization);
  json.field("texelDensity", a.texelDensity);
  json.field("packingCuts", a.packingCuts);
  json.field("packingCutLength", a.packingCutLength);
  json.field("uncutTexelDensity", a.uncutTexelDensity);
  json.end();
}

void writeStages(JsonWriter& json, const UnwrapStages& s) {
  json.field("read", s.read);
  json.field("surface", s.surface);
  json.field("seams", s.seams);
  json.field("solve", s.solve);
  json.field("pack", s.pack);
  json.field("check", s.check);
  json.field("write", s.write);
}

}  // namespace

std::string unwrapReportJson(const UnwrapReport& report) {
  JsonWriter json;
  json.field("version", ABFLAT_VERSION);
  writeInput(json, report.input, report.path, report.error.code);
  writeOptions(json, report.options);
  json.field("threads", report.threads);
  writeRepair(json, report.repair);
  writeSeams(json, report.seams);
  json.array("charts");
  for (const UnwrapChart& chart : report.charts) writeChart(json, chart);
  json.end();
  json.field("notes", report.notes);
  json.field("angularDistortion", report.angularDistortion);
  json.field("quasiConformalMean", report.quasiConformalMean);
  json.field("symmetricDirichlet", report.symmetricDirichlet);
  writeAtlas(json, report.atlas);
  json.field("valid", report.valid);
  json.object("timings");
  writeStages(json, report.timings);
  json.field("total", report.timings.total);
  json.end();
  json.object("peakMemory");
  writeStages(json, report.peakMemory);
  json.end();
  writeError(json, report.error);
  return json.take();
}

}  // namespace abflat
