#pragma once

#include <array>
#include <vector>

#include "base/point2.h"
#include "cut/cut_surface.h"

namespace abflat {

/// The flat layout of a chart's boundary: the position of the first vertex of each half-edge.
using Outline = IdVector<BoundaryIndex, Point2>;

/// `u` is the log-scale of the chart's own solution, 0 on its boundary (the angles are then those
/// of Sawhney and Crane 2017), or that of a larger chart from which it is cut.
Outline predictOutline(const SeamMesh& mesh, const CutSurface& surface, CutChartId chart,
                       const LogScales& u);

/// What the outline predicts about the layout.
struct Shape {
  double fill = 1;     ///< area over that of the convex hull
  double overlap = 0;  ///< area that is covered more than once, over the whole area
  double extent = 0;   ///< see longestExtent()
  /// Pairs of half-edges of the loop that cross, at most `kMostCrossings`.
  std::vector<std::array<BoundaryIndex, 2>> crossings;
};
constexpr std::size_t kMostCrossings = 32;
Shape measureShape(const Outline& outline);

/// A chart of a surface with the log-scale predicted for it.
struct ToldChart {
  const CutSurface& surface;
  CutChartId chart;
  const LogScales& u;
};

/// Whether a chart will overlap itself more than before, on more than `most` of its area or at more
/// places.
bool overlapsMore(const SeamMesh& mesh, const ToldChart& now, const ToldChart& before, double most);

double polygonArea(const Outline& outline);
double hullArea(Outline points);

/// Extent in the direction in which it is largest, accurate to a percent.
double longestExtent(const Outline& outline);

}  // namespace abflat
