#pragma once

#include <vector>

#include "base/parallel.h"
#include "chart/disk_chart.h"
#include "refine/element_energy.h"
#include "refine/rest_triangles.h"
#include "solve/row_system.h"

namespace abflat {

/// The energy of a layout: the weighted sum over its triangles. Infinite if one is flipped. Does
/// not depend on `pool`; null: one thread.
double layoutEnergy(const DiskChart& chart, const RestTriangles& rest, const Energy& energy,
                    const std::vector<double>& uv, ThreadPool* pool = nullptr);

/// The factor by which to scale the layout for the least energy; 1 if scale makes no difference.
double bestScale(const DiskChart& chart, const RestTriangles& rest, const Energy& energy,
                 const std::vector<double>& uv);

/// The rows of a layout: u and v of each vertex.
RowSystem layoutRows(const DiskChart& chart, ThreadPool* pool = nullptr);

/// A layout, and which derivatives of its energy to compute.
struct LayoutPoint {
  const std::vector<double>& uv;
  const Energy& energy;
  ElementCurvature curvature = ElementCurvature::Near;
};

/// Sets the matrix to that of projected Newton and the right-hand side to the gradient. Rows of
/// vertices marked in `isFixed` become identity rows with gradient 0; empty: none.
void assembleDerivatives(const DiskChart& chart, const RestTriangles& rest, const LayoutPoint& at,
                         const IdVector<ChartVertex, std::uint8_t>& isFixed, RowSystem& out);

/// The longest step in a direction, at most `most`, before a triangle loses its area. The layout
/// must have no flipped triangles.
double longestStep(const DiskChart& chart, const RestTriangles& rest, const std::vector<double>& uv,
                   const std::vector<double>& direction, double most, ThreadPool* pool = nullptr);

}  // namespace abflat
