#include "abflat/compare.h"
#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "report_json.h"

namespace abflat {
namespace {

Json historyJson(const std::vector<NewtonStep>& history) {
  Json out = Json::array();
  for (const NewtonStep& s : history)
    out.push_back({{"objective", s.objective},
                   {"constraint", s.constraint},
                   {"gradient", s.gradient},
                   {"active", s.active},
                   {"activeEdges", s.activeEdges},
                   {"step", s.step},
                   {"reweighted", s.reweighted},
                   {"linearIterations", s.linearIterations}});
  return out;
}

Json boundsJson(const std::vector<VertexBound>& bounds) {
  Json out = Json::array();
  for (const VertexBound& b : bounds) out.push_back({{"vertex", b.vertex}, {"t", b.t}});
  return out;
}

Json delaunayJson(const std::optional<DelaunayReport>& d) {
  if (!d) return {};
  return {{"edges", d->edges},
          {"violatedBefore", d->violatedBefore},
          {"violated", d->violated},
          {"angularDistortionBefore", d->angularDistortionBefore},
          {"resisting", d->resisting}};
}

Json chartJson(const ChartReport& c) {
  return {
      {"faces", c.faces},
      {"boundaryVertices", c.boundaryVertices},
      {"t", c.t},
      {"bounds", boundsJson(c.bounds)},
      {"solver", c.solver},
      {"linearSolver", c.linearSolver},
      {"formulation", c.formulation},
      {"iterations", c.iterations},
      {"history", historyJson(c.history)},
      {"constraintResidual", c.constraintResidual},
      {"converged", c.converged},
      {"angularDistortion", c.angularDistortion},
      {"lengthDistortion", c.lengthDistortion},
      {"quasiConformal", {{"mean", c.quasiConformalMean}, {"max", c.quasiConformalMax}}},
      {"stretch", {{"l2", c.stretchL2}, {"linf", c.stretchLinf}}},
      {"symmetricDirichlet", c.symmetricDirichlet},
      {"areaDistortion", {{"min", c.areaDistortionMin}, {"max", c.areaDistortionMax}}},
      {"degenerateTriangles", c.degenerateTriangles},
      {"flippedTriangles", c.flippedTriangles},
      {"boundaryCrossings", c.boundaryCrossings},
      {"maxBoundaryAngle", c.maxBoundaryAngle},
      {"delaunay", delaunayJson(c.delaunay)},
      {"refined", refinedJson(c.refined)},
      {"pins", pinsJson(c.pins)},
      {"straight", straightJson(c.straight)},
      {"fallbacks", c.fallbacks},
      {"problem", c.problem},
      {"valid", c.valid},
  };
}

Json timingsJson(const Timings& t) {
  return {
      {"read", t.read},     {"connectivity", t.connectivity},
      {"solve", t.solve},   {"layout", t.layout},
      {"refine", t.refine}, {"check", t.check},
      {"write", t.write},   {"total", t.total},
  };
}

Json summaryJson(const MeshSummary& s, const std::string& path) {
  return {
      {"path", path},
      {"vertices", s.vertices},
      {"unreferencedVertices", s.unreferencedVertices},
      {"faces", s.faces},
      {"triangles", s.triangles},
      {"components", s.components},
      {"boundaryLoops", s.boundaryLoops},
      {"boundaryEdges", s.boundaryEdges},
      {"nonManifoldEdges", s.nonManifoldEdges},
      {"orientationConflicts", s.orientationConflicts},
      {"degenerateFaces", s.degenerateFaces},
      {"eulerCharacteristic", s.eulerCharacteristic},
      {"genus", s.genus},
      {"texcoords", s.texcoords},
      {"materials", s.materials},
      {"disk",
       {{"ok", s.disk.ok()}, {"code", statusName(s.disk.code)}, {"message", s.disk.message}}},
  };
}

Json methodJson(const MethodResult& m) {
  return {
      {"method", m.method},
      {"title", m.title},
      {"seconds", m.seconds},
      {"angularDistortion", m.angularDistortion},
      {"lengthDistortion", m.lengthDistortion},
      {"areaDistortion", m.areaDistortion},
      {"areaRatio", {{"min", m.areaRatioMin}, {"max", m.areaRatioMax}}},
      {"quasiConformal", {{"mean", m.quasiConformalMean}, {"max", m.quasiConformalMax}}},
      {"symmetricDirichlet", m.symmetricDirichlet},
      {"flippedTriangles", m.flippedTriangles},
      {"boundaryCrossings", m.boundaryCrossings},
      {"valid", m.valid},
      {"problem", m.problem},
  };
}

}  // namespace

std::string reportJson(const Report& report) {
  Json charts = Json::array();
  for (const ChartReport& chart : report.charts) charts.push_back(chartJson(chart));
  Json out = {
      {"version", ABFLAT_VERSION},
      {"input", inputJson(report.input, report.path, report.error.code)},
      {"options", optionsJson(report.options)},
      {"threads", report.threads},
      {"charts", charts},
      {"valid", report.valid},
      {"timings", timingsJson(report.timings)},
  };
  if (!report.error.ok()) out["error"] = errorJson(report.error);
  return jsonText(out);
}

std::string inspectJson(const MeshSummary& summary, const std::string& path) {
  return jsonText(summaryJson(summary, path));
}

std::string compareJson(const Comparison& comparison, const std::string& path) {
  Json methods = Json::array();
  for (const MethodResult& row : comparison.methods) methods.push_back(methodJson(row));
  return jsonText({{"version", ABFLAT_VERSION},
                   {"input", summaryJson(comparison.input, path)},
                   {"methods", methods}});
}

}  // namespace abflat
