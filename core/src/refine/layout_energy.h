#pragma once

#include <vector>

#include "base/parallel.h"
#include "chart/disk_chart.h"
#include "refine/rest_triangles.h"

namespace abflat {

/// The energy of a layout: that of its triangles by weight. Infinite where one is flipped. Does not
/// depend on `pool`; null: one thread.
double layoutEnergy(const DiskChart& chart, const RestTriangles& rest, double balance,
                    const std::vector<double>& uv, ThreadPool* pool = nullptr);

/// What the layout has to be scaled by to have the least energy; 1 where that is all the same.
double bestScale(const DiskChart& chart, const RestTriangles& rest, double balance,
                 const std::vector<double>& uv);

/// The longest step in a direction, at most `most`, before a triangle of a layout without flipped
/// ones has no area.
double longestStep(const DiskChart& chart, const RestTriangles& rest, const std::vector<double>& uv,
                   const std::vector<double>& direction, double most, ThreadPool* pool = nullptr);

}  // namespace abflat
