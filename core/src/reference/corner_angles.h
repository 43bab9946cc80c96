#pragma once

#include "chart/disk_chart.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

/// 3D angle of every corner; triangles without area get made-up angles above 0.
inline IdVector<ChartCorner, double> drawableAngles(const DiskChart& chart) {
  IdVector<ChartCorner, double> out;
  out.reserve(chart.vertexOfCorner.size());
  for (const ChartTriangle f : chart.triangles())
    for (const double a :
         anglesOrMadeUp(chart.positions, verticesOf(chart.vertexOfCorner, f), chart.angles[f]))
      out.push_back(a);
  return out;
}

}  // namespace abflat
