#pragma once

#include <vector>

#include "chart/disk_chart.h"
#include "refine/plane_map.h"

namespace abflat {

/// The target shape of a triangle, in a plane of its own, and its share of the energy. The map from
/// there to vertices at x0, x1, x2 (complex numbers) has z = sum conj(c_k) x_k and w = sum c_k x_k
/// with c_1 = (c1x, c1y), c_2 = (0, c2y), c_0 = -c_1 - c_2.
struct RestTriangle {
  double c1x = 0, c1y = 0, c2y = 0;
  double weight = 0;  ///< 0: left out

  PlaneMap mapTo(const double* x0, const double* x1, const double* x2) const {
    const double ux = x1[0] - x0[0], uy = x1[1] - x0[1], vx = x2[0] - x0[0], vy = x2[1] - x0[1];
    return {c1x * ux + c1y * uy + c2y * vy, c1x * uy - c1y * ux - c2y * vx,
            c1x * ux - c1y * uy - c2y * vy, c1x * uy + c1y * ux + c2y * vx};
  }
};

/// The chart's triangles as they are on the surface, weighted by area; weights sum to 1. Triangles
/// without area there, and those that fill holes, should stay as they are in `uv`; they have little
/// weight.
using RestTriangles = IdVector<ChartTriangle, RestTriangle>;
RestTriangles restTriangles(const DiskChart& chart, const std::vector<double>& uv);

}  // namespace abflat
