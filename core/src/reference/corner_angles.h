#pragma once

#include <vector>

#include "chart/disk_chart.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

/// 3D angle of every corner; those of triangles without area are made up and above 0.
inline std::vector<double> drawableAngles(const DiskChart& chart) {
  std::vector<double> out;
  out.reserve(chart.vertexOfCorner.size());
  for (std::uint32_t f = 0; f < chart.triangleCount(); ++f)
    for (const double a :
         anglesOrMadeUp(chart.positions, &chart.vertexOfCorner[3 * f], chart.angles[f]))
      out.push_back(a);
  return out;
}

}  // namespace abflat
