#pragma once

#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// Where s1/s2 exceeds this, it can be seen.
constexpr double kSheared = 1.25;

/// How far a layout is from an isometry, measured on coordinates alone. Triangles of zero area in
/// 3D are left out, and so are slivers, whose height is less than a millionth of the chart's
/// extent, unless there is nothing else. s1 >= s2 are a triangle's singular values of the map from
/// 3D to uv, after both have been scaled to the same total area; means are weighted by 3D area.
struct Distortion {
  double angular = 0;             ///< mean over corners of ((x - alpha)/alpha)^2
  double length = 0;              ///< mean over edges of (s L/l - 1)^2 with s = sum l / sum L
  double quasiConformalMean = 1;  ///< s1/s2
  double quasiConformalMax = 1;
  double sheared = 0;               ///< share of the area where s1/s2 exceeds kSheared
  double stretchL2 = 1;             ///< root of the mean of (1/s1^2 + 1/s2^2)/2, Sander et al. 2001
  double stretchLinf = 1;           ///< largest 1/s2
  double symmetricDirichlet = 1;    ///< (s1^2 + s2^2 + 1/s1^2 + 1/s2^2)/4
  double areaMin = 1, areaMax = 1;  ///< s1 s2
  double areaLog = 0;               ///< mean of |log(s1 s2)|
};
Distortion measureDistortion(const DiskChart& chart, const std::vector<double>& uv);

}  // namespace abflat
