#include "flatten/chart_report.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/counted.h"
#include "base/number_text.h"
#include "base/point2.h"
#include "base/portable_math.h"
#include "check/distortion.h"

namespace abflat {
namespace {

/// Orders of magnitude between the longest and the shortest edge of the layout.
int edgeRange(const DiskChart& chart, const std::vector<double>& uv) {
  double longest = 0, shortest = INFINITY;
  for (const ChartCorner h : chart.surfaceCorners()) {
    const Point2 a = pointAt(uv, chart.vertexOfCorner[h]);
    const Point2 b = pointAt(uv, chart.vertexOfCorner[nextCorner(h)]);
    const double length = portable::hypot(a[0] - b[0], a[1] - b[1]);
    longest = std::max(longest, length);
    shortest = std::min(shortest, length);
  }
  return shortest > 0 ? static_cast<int>(std::log10(longest / shortest)) : 300;
}

std::string flippedText(const DiskChart& chart, const Attempt& a) {
  constexpr int kDrawable =
      12;  // orders of magnitude that doubles resolve beyond the errors of the layout
  const bool isStraight = a.straight && a.straight->vertices > 0;
  const std::string flipped = counted(a.validity.flippedTriangles, "triangle is", "triangles are") +
                              " flipped or degenerate";
  const std::string shorten = ". Shorten or remove straight runs";
  const int range = edgeRange(chart, a.uv);
  if (range < kDrawable) return flipped + (isStraight ? shorten : "");
  return flipped + (isStraight ? ": " : ": with these bounds, ") + "edge lengths span " +
         (range < 300 ? std::to_string(range) : "over 300") +
         " orders of magnitude, more than doubles can represent" +
         (isStraight ? shorten : ". Allow a larger t");
}

}  // namespace

std::string missedText(const MissedAngles& exceeded, const MissedAngles& bent) {
  std::string out;
  if (exceeded.count > 0)
    out = "the layout exceeds " + std::to_string(exceeded.count) +
          " of the requested bounds, by up to " + withDigits(exceeded.most / kPi, 3) + " pi";
  if (bent.count > 0)
    out += (out.empty() ? "" : "; ") + std::string("straight runs bend at ") +
           counted(bent.count, "vertex", "vertices") + ", by up to " + withDigits(bent.most, 3) +
           " radians";
  return out;
}

std::string findProblem(const DiskChart& chart, const Attempt& a) {
  const Validity& v = a.validity;
  if (!a.converged())
    return "the solver did not converge: constraint residual " +
           withDigits(a.solution.constraintResidual, 2) + " after " +
           std::to_string(a.solution.history.size()) + " steps" +
           (a.straight ? ". Shorten or remove straight runs" : "");
  if (a.pins && a.wasValidUnpinned && !v.valid())
    return "the pins fold the layout: " +
           (v.flippedTriangles > 0 ? counted(v.flippedTriangles, "triangle is", "triangles are") +
                                         " flipped or degenerate"
                                   : "its boundary crosses itself at " +
                                         counted(v.crossings.count, "place", "places")) +
           ". Move the pins closer to the layout without pins, or remove some";
  if (v.flippedTriangles > 0) return flippedText(chart, a);
  if (v.crossings.count > 0)
    return "the boundary crosses itself at " + counted(v.crossings.count, "place", "places") +
           ". A smaller t, down to 1, straightens it; t = auto finds out how small";
  if (!a.hasAskedAngles())
    return missedText(a.exceeded, a.bent) +
           (a.bent.count > 0 ? ". Shorten or remove straight runs" : ". Raise or remove some");
  return {};
}

void setMeasures(ChartReport& r, const Validity& v, const Distortion& d) {
  r.angularDistortion = d.angular;
  r.lengthDistortion = d.length;
  r.quasiConformalMean = d.quasiConformalMean;
  r.quasiConformalMax = d.quasiConformalMax;
  r.quasiConformalSheared = d.sheared;
  r.stretchL2 = d.stretchL2;
  r.stretchLinf = d.stretchLinf;
  r.symmetricDirichlet = d.symmetricDirichlet;
  r.areaDistortionMin = d.areaMin;
  r.areaDistortionMax = d.areaMax;
  r.degenerateTriangles = v.degenerateTriangles;
  r.flippedTriangles = v.flippedTriangles;
  r.boundaryCrossings = v.crossings.count;
  r.maxBoundaryAngle = v.maxBoundaryAngle;
}

ChartReport makeChartReport(const DiskChart& chart, const Attempt& attempt, double t) {
  const AngleSolution& s = attempt.solution;
  ChartReport r;
  r.faces = chart.surfaceTriangles().size();
  r.boundaryVertices = chart.boundary.size();
  r.t = t;
  for (const BoundaryIndex i : chart.boundary.ids())
    if (attempt.t[i] < std::min(t, 2.0))
      r.bounds.push_back({chart.inputVertex[chart.boundaryVertex(i)], attempt.t[i]});
  r.solver = attempt.solver;
  r.linearSolver = s.linearSolver;
  r.formulation = s.formulation;
  r.iterations = static_cast<int>(s.history.size());
  r.history = s.history;
  r.constraintResidual = s.constraintResidual;
  r.converged = attempt.converged();
  setMeasures(r, attempt.validity, attempt.distortion);
  r.delaunay = attempt.delaunay;
  r.refined = attempt.refined;
  r.pins = attempt.pins;
  r.straight = attempt.straight;
  r.fallbacks = attempt.fallbacks;
  r.problem = findProblem(chart, attempt);
  r.valid = r.problem.empty();
  return r;
}

}  // namespace abflat
