#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "abflat/flatten.h"
#include "abflat/unit_square.h"
#include "base/counted.h"
#include "base/number_text.h"
#include "base/round_texcoords.h"
#include "base/stopwatch.h"
#include "boundary/missed_angles.h"
#include "boundary/requested_bounds.h"
#include "boundary/straight_runs.h"
#include "chart/disk_chart.h"
#include "check/delaunay.h"
#include "check/distortion.h"
#include "check/validity.h"
#include "flatten/chart_report.h"
#include "mesh/surface.h"

namespace abflat {
namespace {

/// A power of two about as large as the layout. Dividing by it changes no digit, and afterwards no
/// product overflows.
double sizeOf(const std::vector<double>& uv) {
  double most = 0;
  for (const double x : uv) most = std::max(most, std::abs(x));
  return most > 0 && std::isfinite(most) ? std::ldexp(1, std::ilogb(most)) : 1;
}

/// A layout after rounding, in its own unit.
struct Rounded {
  std::vector<double> uv;
  Validity validity;
  Distortion distortion;
  std::size_t violatedEdges = 0;  ///< edges that violate the Delaunay condition, if it is asked for
  double straightDeviation = 0;   ///< along runs that are to be straight
  double angleMissedBy = 0;       ///< radians: of boundary angles, beyond rounding
};

/// Why a rounded layout is not valid; empty if it is valid.
std::string findDefect(const Rounded& rounded) {
  const Validity& validity = rounded.validity;
  if (validity.flippedTriangles > 0)
    return counted(validity.flippedTriangles, "triangle would", "triangles would") +
           " be flipped or degenerate";
  if (validity.crossings.count > 0)
    return "the boundary would cross itself at " +
           counted(validity.crossings.count, "place", "places");
  if (rounded.angleMissedBy > 0)
    return "boundary angles would be off by up to " + withDigits(rounded.angleMissedBy, 2) +
           " radians";
  return {};
}

Rounded measured(const DiskChart& chart, const FlattenResult& result, std::vector<double> uv) {
  Rounded out;
  std::vector<double> inUnits;
  inUnits.reserve(uv.size());
  const double size = sizeOf(uv);
  for (const double x : uv) inUnits.push_back(x / size);
  out.uv = std::move(uv);
  out.validity = checkValidity(chart, inUnits);
  out.distortion = measureDistortion(chart, inUnits);
  if (result.report.charts.front().delaunay)
    out.violatedEdges = checkDelaunay(chart, inUnits).violated.size();
  const StraightPlaces straight = placesOf(chart, result.straight);
  out.straightDeviation = reportStraight(chart, straight, inUnits).deviation;
  if (result.report.charts.front().pins) return out;
  constexpr double kRounding = kAngleRoundingInSingle;
  const MissedAngles missed[] = {
      exceededBounds(chart, inUnits, boundsOf(chart, result.bounds), straight, kRounding),
      bentPlaces(chart, inUnits, straight, kRounding)};
  for (const MissedAngles& m : missed)
    if (m.count > 0) out.angleMissedBy = std::max(out.angleMissedBy, m.most);
  return out;
}

/// Makes the report describe the rounded layout.
void setMeasures(ChartReport& report, const Rounded& rounded) {
  setMeasures(report, rounded.validity, rounded.distortion);
  if (report.straight) report.straight->deviation = rounded.straightDeviation;
}

/// Replaces the layout that the report describes by one that was moved or rounded.
void replaceLayout(const DiskChart& chart, std::vector<double> uv, const std::string& where,
                   const std::string& remedy, FlattenResult& result) {
  ChartReport& report = result.report.charts.front();
  Rounded rounded = measured(chart, result, std::move(uv));
  setMeasures(report, rounded);
  if (report.delaunay) report.delaunay->violated = rounded.violatedEdges;
  const std::string defect = findDefect(rounded);
  if (report.valid && !defect.empty()) {
    report.problem = where + defect + remedy;
    report.valid = result.report.valid = false;
  }
  result.uv = std::move(rounded.uv);
}

/// Fits the layout to 0..1 along its longer side, and from 0 along the other. Leaves it unchanged
/// if that is not possible.
void moveToUnitSquare(std::vector<double>& uv) {
  std::array<double, 2> least{HUGE_VAL, HUGE_VAL}, most{-HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = 0; i < uv.size(); ++i) {
    least[i % 2] = std::min(least[i % 2], uv[i]);
    most[i % 2] = std::max(most[i % 2], uv[i]);
  }
  const double extent = std::max(most[0] - least[0], most[1] - least[1]);
  if (!(extent > 0) || !std::isfinite(extent)) return;
  for (std::size_t i = 0; i < uv.size(); ++i) uv[i] = (uv[i] - least[i % 2]) / extent;
}

}  // namespace

bool roundToSinglePrecision(const PolygonMesh& mesh, FlattenResult& result) {
  if (!result.report.valid) return false;
  Stopwatch watch;
  const DiskChart chart = makeDiskChart(mesh, buildSurface(mesh));
  ChartReport& report = result.report.charts.front();
  std::vector<double> uv = result.uv;
  roundToSingle(uv);
  Rounded rounded = measured(chart, result, std::move(uv));
  std::string obstacle = findDefect(rounded);
  if (obstacle.empty() && report.delaunay && rounded.violatedEdges > report.delaunay->violated)
    obstacle = counted(rounded.violatedEdges - report.delaunay->violated, "edge", "edges") +
               " more would not be Delaunay";
  if (obstacle.empty()) {
    setMeasures(report, rounded);
    result.uv = std::move(rounded.uv);
  } else {
    report.fallbacks.push_back("texcoords are in double precision: rounded to single precision, " +
                               obstacle);
  }
  result.report.timings.check += watch.lap();
  return obstacle.empty();
}

void roundForGltf(const PolygonMesh& mesh, FlattenResult& result) {
  Stopwatch watch;
  const DiskChart chart = makeDiskChart(mesh, buildSurface(mesh));
  std::vector<double> uv = result.uv;
  roundForGltf(uv);
  replaceLayout(chart, std::move(uv), "in single precision, the only one in glTF, ",
                ". Write OBJ or PLY instead", result);
  result.report.timings.check += watch.lap();
}

void fitUnitSquare(const PolygonMesh& mesh, FlattenResult& result) {
  Stopwatch watch;
  const DiskChart chart = makeDiskChart(mesh, buildSurface(mesh));
  std::vector<double> uv = result.uv;
  moveToUnitSquare(uv);
  replaceLayout(chart, std::move(uv), "scaled into the unit square, ",
                ". Scale the mesh closer to size 1", result);
  result.report.timings.check += watch.lap();
}

}  // namespace abflat
