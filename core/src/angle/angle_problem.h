#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "chart/disk_chart.h"

namespace abflat {

/// The constrained minimisation of the paper, section 5, for one chart. Angles in radians, one per
/// corner c.
///
///   minimise   sum_c w_c (x_c - a_c)^2
///   subject to triangle sums = pi                                      (2)
///              sums round interior vertices = 2 pi                     (1)
///              sum log sin(next) - log sin(prev) = 0 there             (6)
///              sums at boundary vertices <= bound                      (4), with t
///              sums at straight ones = pi
///              pairs opposite an interior edge <= limit                (9), only for Delaunay
struct AngleProblem {
  IdVector<ChartCorner, ChartVertex> vertexOfCorner;
  IdVector<ChartVertex, std::uint8_t> isBoundary;
  IdVector<ChartCorner, double> target;  ///< a, > 0
  IdVector<ChartCorner, double> weight;  ///< w = 1/a^2
  /// 2 pi inside, the upper bound on the boundary (infinite if there is none).
  IdVector<ChartVertex, double> angleSum;
  IdVector<ChartVertex, std::uint8_t> isStraight;  ///< boundary vertices whose bound is met exactly
  /// The two corners opposite each edge of condition (9); empty: no condition.
  std::vector<std::array<ChartCorner, 2>> edgeCorners;
  /// The edge opposite the corner or kNone; empty like edgeCorners.
  IdVector<ChartCorner, std::uint32_t> edgeOfCorner;
  double edgeLimit = 0;  ///< largest sum of the two angles opposite an edge
  /// Condition (9) may be violated by this times its multiplier: the optimum of a quadratic penalty
  /// of weight 1/compliance, which exists even where the condition cannot be met.
  double edgeCompliance = 0;

  IdVector<ChartVertex, std::uint32_t> eliminationRank;  ///< see DiskChart

  std::uint32_t triangleCount() const {
    return static_cast<std::uint32_t>(vertexOfCorner.size() / 3);
  }
  std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(isBoundary.size()); }
  IdRange<ChartTriangle> triangles() const { return IdRange<ChartTriangle>(triangleCount()); }
  IdRange<ChartCorner> corners() const { return vertexOfCorner.ids(); }
  IdRange<ChartVertex> vertices() const { return isBoundary.ids(); }
};

/// Targets a from the 3D angles: scaled to sum to 2 pi round an interior vertex, unchanged at a
/// boundary vertex.
/// `pool`: null for one thread.
AngleProblem buildAngleProblem(const DiskChart& chart, ThreadPool* pool = nullptr);

/// Upper bounds t_v pi of the angle sums at the chart's boundary vertices: condition (4) with the
/// boundary control coefficient. t >= 2 is classic ABF, which has no condition on the boundary.
void setBounds(AngleProblem& problem, const DiskChart& chart, const BoundaryBounds& t);

/// Sets bounds of pi that are met exactly, for the boundary vertices marked in `straight`. Empty:
/// none.
void setStraight(AngleProblem& problem, const DiskChart& chart, const StraightPlaces& straight);

/// Sets condition (9), alpha_1 + alpha_2 <= pi - margin, for every interior edge. No margin: drops
/// it.
void setDelaunay(AngleProblem& problem, const DiskChart& chart, std::optional<double> margin);

}  // namespace abflat
