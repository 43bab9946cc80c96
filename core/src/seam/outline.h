#pragma once

#include <array>
#include <vector>

#include "cut/cut_surface.h"

namespace abflat {

using Point2 = std::array<double, 2>;

/// Where the boundary of a chart will lie when it is flattened, one point per half-edge of its loop
/// (its first vertex). `u` is the log-scale per vertex of the mesh: of the chart's own solution, 0
/// on its boundary (the angles are then those of Sawhney and Crane 2017), or of a larger chart that
/// it is cut out of.
std::vector<Point2> predictOutline(const SeamMesh& mesh, const CutSurface& surface,
                                   std::uint32_t chart, const std::vector<double>& u);

/// What the outline tells about the layout.
struct Shape {
  double fill = 1;     ///< area over that of the convex hull
  double overlap = 0;  ///< area that is covered more than once, over the whole
  double extent = 0;   ///< see longestExtent()
  /// Pairs of half-edges of the loop that cross, at most `kMostCrossings`.
  std::vector<std::array<std::uint32_t, 2>> crossings;
};
constexpr std::size_t kMostCrossings = 32;
Shape measureShape(const std::vector<Point2>& outline);

/// A chart of a surface with the log-scale that is told for it.
struct ToldChart {
  const CutSurface& surface;
  std::uint32_t chart;
  const std::vector<double>& u;
};

/// Whether a chart will lie on itself, more than it did and on more than `most` of its area or at
/// more places.
bool overlapsMore(const SeamMesh& mesh, const ToldChart& now, const ToldChart& before, double most);

double polygonArea(const std::vector<Point2>& points);
double hullArea(std::vector<Point2> points);

/// In the direction in which it is largest, to a percent.
double longestExtent(const std::vector<Point2>& points);

}  // namespace abflat
