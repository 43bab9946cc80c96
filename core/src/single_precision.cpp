#include <cmath>

#include "abflat/flatten.h"
#include "chart/disk_chart.h"
#include "chart_report.h"
#include "check/delaunay.h"
#include "check/distortion.h"
#include "check/validity.h"
#include "mesh/surface.h"
#include "stopwatch.h"

namespace abflat {
namespace {

std::string count(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// Why a valid layout cannot be rounded; empty when it can.
std::string findObstacle(const DiskChart& chart, const ChartReport& report,
                         const std::vector<double>& uv, const Validity& validity) {
  if (validity.flippedTriangles > 0)
    return count(validity.flippedTriangles, "triangle", "triangles") +
           " would be flipped or without area";
  if (validity.crossings.count > 0)
    return "the boundary would cross itself at " +
           count(validity.crossings.count, "place", "places");
  if (!report.delaunay) return {};
  const std::size_t violated = checkDelaunay(chart, uv).violated.size();
  if (violated <= report.delaunay->violated) return {};
  return count(violated - report.delaunay->violated, "edge", "edges") +
         " more would not be Delaunay";
}

}  // namespace

bool roundToSinglePrecision(const PolygonMesh& mesh, FlattenResult& result) {
  if (!result.report.valid) return false;
  Stopwatch watch;
  const DiskChart chart = makeDiskChart(mesh, buildSurface(mesh));
  ChartReport& report = result.report.charts.front();
  std::vector<double> rounded = result.uv, inUnits;
  inUnits.reserve(rounded.size());
  for (double& x : rounded) {
    x = static_cast<double>(static_cast<float>(x));
    inUnits.push_back(x / chart.unit);
  }
  const Validity validity = checkValidity(chart, inUnits);
  const std::string obstacle = findObstacle(chart, report, inUnits, validity);
  if (obstacle.empty()) {
    setMeasures(report, validity, measureDistortion(chart, inUnits));
    result.uv = std::move(rounded);
  } else {
    report.fallbacks.push_back("texcoords are written in double precision: rounded to single, " +
                               obstacle);
  }
  result.report.timings.check += watch.lap();
  return obstacle.empty();
}

}  // namespace abflat
