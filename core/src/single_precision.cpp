#include <utility>

#include "abflat/flatten.h"
#include "chart/disk_chart.h"
#include "chart_report.h"
#include "check/delaunay.h"
#include "check/distortion.h"
#include "check/validity.h"
#include "mesh/surface.h"
#include "round_texcoords.h"
#include "stopwatch.h"

namespace abflat {
namespace {

std::string count(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// Why a rounded layout is not valid; empty when it is.
std::string findDefect(const Validity& validity) {
  if (validity.flippedTriangles > 0)
    return count(validity.flippedTriangles, "triangle would", "triangles would") +
           " be flipped or without area";
  if (validity.crossings.count > 0)
    return "the boundary would cross itself at " +
           count(validity.crossings.count, "place", "places");
  return {};
}

/// A layout after rounding, in its own unit.
struct Rounded {
  std::vector<double> uv;
  Validity validity;
  Distortion distortion;
  std::size_t violatedEdges = 0;  ///< of the Delaunay condition, where it is asked for
};

Rounded measured(const DiskChart& chart, const ChartReport& report, std::vector<double> uv) {
  Rounded out;
  std::vector<double> inUnits;
  inUnits.reserve(uv.size());
  for (const double x : uv) inUnits.push_back(x / chart.unit);
  out.uv = std::move(uv);
  out.validity = checkValidity(chart, inUnits);
  out.distortion = measureDistortion(chart, inUnits);
  if (report.delaunay) out.violatedEdges = checkDelaunay(chart, inUnits).violated.size();
  return out;
}

}  // namespace

bool roundToSinglePrecision(const PolygonMesh& mesh, FlattenResult& result) {
  if (!result.report.valid) return false;
  Stopwatch watch;
  const DiskChart chart = makeDiskChart(mesh, buildSurface(mesh));
  ChartReport& report = result.report.charts.front();
  std::vector<double> uv = result.uv;
  roundToSingle(uv);
  Rounded rounded = measured(chart, report, std::move(uv));
  std::string obstacle = findDefect(rounded.validity);
  if (obstacle.empty() && report.delaunay && rounded.violatedEdges > report.delaunay->violated)
    obstacle = count(rounded.violatedEdges - report.delaunay->violated, "edge", "edges") +
               " more would not be Delaunay";
  if (obstacle.empty()) {
    setMeasures(report, rounded.validity, rounded.distortion);
    result.uv = std::move(rounded.uv);
  } else {
    report.fallbacks.push_back("texcoords are written in double precision: rounded to single, " +
                               obstacle);
  }
  result.report.timings.check += watch.lap();
  return obstacle.empty();
}

void roundForGltf(const PolygonMesh& mesh, FlattenResult& result) {
  Stopwatch watch;
  const DiskChart chart = makeDiskChart(mesh, buildSurface(mesh));
  ChartReport& report = result.report.charts.front();
  roundForGltf(result.uv);
  const Rounded rounded = measured(chart, report, result.uv);
  setMeasures(report, rounded.validity, rounded.distortion);
  if (report.delaunay) report.delaunay->violated = rounded.violatedEdges;
  const std::string defect = findDefect(rounded.validity);
  if (report.valid && !defect.empty()) {
    report.problem =
        "in single precision, which is all that a glTF has, " + defect + "; write an OBJ or PLY";
    report.valid = result.report.valid = false;
  }
  result.report.timings.check += watch.lap();
}

}  // namespace abflat
