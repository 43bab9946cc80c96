#pragma once

#include <vector>

#include "chart/chart_set.h"

namespace abflat {

/// How much of a chart's outline runs along the two directions of one cross.
struct RightAngled {
  double length = 0;  ///< of the outline
  double along = 0;   ///< all of it for a rectangle, nothing for a circle

  double share() const { return length > 0 ? along / length : 1; }
  RightAngled& operator+=(const RightAngled& other) {
    length += other.length;
    along += other.along;
    return *this;
  }
};
RightAngled rightAngled(const ChartTopology& topology, const std::vector<double>& uv);

}  // namespace abflat
