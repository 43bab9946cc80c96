#include "abflat/compare.h"
#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "report/report_json.h"

namespace abflat {
namespace {

void writeHistory(JsonWriter& json, const std::vector<NewtonStep>& history) {
  json.array("history");
  for (const NewtonStep& s : history) {
    json.object();
    json.field("objective", s.objective);
    json.field("constraint", s.constraint);
    json.field("gradient", s.gradient);
    json.field("active", s.active);
    json.field("activeEdges", s.activeEdges);
    json.field("step", s.step);
    json.field("reweighted", s.reweighted);
    json.field("linearIterations", s.linearIterations);
    json.end();
  }
  json.end();
}

void writeBounds(JsonWriter& json, const std::vector<VertexBound>& bounds) {
  json.array("bounds");
  for (const VertexBound& b : bounds) {
    json.object();
    json.field("vertex", b.vertex);
    json.field("t", b.t);
    json.end();
  }
  json.end();
}

void writeDelaunay(JsonWriter& json, const std::optional<DelaunayReport>& d) {
  if (!d) return json.null("delaunay");
  json.object("delaunay");
  json.field("edges", d->edges);
  json.field("violatedBefore", d->violatedBefore);
  json.field("violated", d->violated);
  json.field("angularDistortionBefore", d->angularDistortionBefore);
  json.field("resisting", d->resisting);
  json.end();
}

void writeMinMax(JsonWriter& json, const char* name, double min, double max) {
  json.object(name);
  json.field("min", min);
  json.field("max", max);
  json.end();
}

void writeMeasures(JsonWriter& json, const ChartReport& c) {
  json.field("angularDistortion", c.angularDistortion);
  json.field("lengthDistortion", c.lengthDistortion);
  writeQuasiConformal(json, c.quasiConformalMean, c.quasiConformalMax);
  json.object("stretch");
  json.field("l2", c.stretchL2);
  json.field("linf", c.stretchLinf);
  json.end();
  json.field("symmetricDirichlet", c.symmetricDirichlet);
  writeMinMax(json, "areaDistortion", c.areaDistortionMin, c.areaDistortionMax);
  json.field("degenerateTriangles", c.degenerateTriangles);
  json.field("flippedTriangles", c.flippedTriangles);
  json.field("boundaryCrossings", c.boundaryCrossings);
  json.field("maxBoundaryAngle", c.maxBoundaryAngle);
}

void writeChart(JsonWriter& json, const ChartReport& c) {
  json.object();
  json.field("faces", c.faces);
  json.field("boundaryVertices", c.boundaryVertices);
  json.field("t", c.t);
  writeBounds(json, c.bounds);
  json.field("solver", nameOf(c.solver));
  json.field("linearSolver", nameOf(c.linearSolver));
  json.field("formulation", nameOf(c.formulation));
  json.field("iterations", c.iterations);
  writeHistory(json, c.history);
  json.field("constraintResidual", c.constraintResidual);
  json.field("converged", c.converged);
  writeMeasures(json, c);
  writeDelaunay(json, c.delaunay);
  writeRefined(json, c.refined);
  writePins(json, c.pins);
  writeStraight(json, c.straight);
  json.field("fallbacks", c.fallbacks);
  json.field("problem", c.problem);
  json.field("valid", c.valid);
  json.end();
}

void writeTimings(JsonWriter& json, const Timings& t) {
  json.object("timings");
  json.field("read", t.read);
  json.field("connectivity", t.connectivity);
  json.field("solve", t.solve);
  json.field("layout", t.layout);
  json.field("refine", t.refine);
  json.field("check", t.check);
  json.field("write", t.write);
  json.field("total", t.total);
  json.end();
}

void writeSummary(JsonWriter& json, const MeshSummary& s, const std::string& path) {
  json.field("path", path);
  json.field("vertices", s.vertices);
  json.field("unreferencedVertices", s.unreferencedVertices);
  json.field("faces", s.faces);
  json.field("triangles", s.triangles);
  json.field("components", s.components);
  json.field("boundaryLoops", s.boundaryLoops);
  json.field("boundaryEdges", s.boundaryEdges);
  json.field("nonManifoldEdges", s.nonManifoldEdges);
  json.field("orientationConflicts", s.orientationConflicts);
  json.field("degenerateFaces", s.degenerateFaces);
  json.field("eulerCharacteristic", s.eulerCharacteristic);
  json.field("genus", s.genus);
  json.field("texcoords", s.texcoords);
  json.field("materials", s.materials);
  json.object("disk");
  json.field("ok", s.disk.ok());
  json.field("code", statusName(s.disk.code));
  json.field("message", s.disk.message);
  json.end();
}

void writeMethod(JsonWriter& json, const MethodResult& m) {
  json.object();
  json.field("method", nameOf(m.method));
  json.field("title", m.title);
  json.field("seconds", m.seconds);
  json.field("angularDistortion", m.angularDistortion);
  json.field("lengthDistortion", m.lengthDistortion);
  json.field("areaDistortion", m.areaDistortion);
  writeMinMax(json, "areaRatio", m.areaRatioMin, m.areaRatioMax);
  writeQuasiConformal(json, m.quasiConformalMean, m.quasiConformalMax);
  json.field("symmetricDirichlet", m.symmetricDirichlet);
  json.field("flippedTriangles", m.flippedTriangles);
  json.field("boundaryCrossings", m.boundaryCrossings);
  json.field("valid", m.valid);
  json.field("problem", m.problem);
  json.end();
}

}  // namespace

std::string reportJson(const Report& report) {
  JsonWriter json;
  json.field("version", ABFLAT_VERSION);
  writeInput(json, report.input, report.path, report.error.code);
  writeOptions(json, report.options);
  json.field("threads", report.threads);
  json.array("charts");
  for (const ChartReport& chart : report.charts) writeChart(json, chart);
  json.end();
  json.field("valid", report.valid);
  writeTimings(json, report.timings);
  writeError(json, report.error);
  return json.take();
}

std::string inspectJson(const MeshSummary& summary, const std::string& path) {
  JsonWriter json;
  writeSummary(json, summary, path);
  return json.take();
}

std::string compareJson(const Comparison& comparison, const std::string& path) {
  JsonWriter json;
  json.field("version", ABFLAT_VERSION);
  json.object("input");
  writeSummary(json, comparison.input, path);
  json.end();
  json.array("methods");
  for (const MethodResult& row : comparison.methods) writeMethod(json, row);
  json.end();
  return json.take();
}

}  // namespace abflat
