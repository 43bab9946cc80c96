#pragma once

#include "seam/find_seams.h"
#include "seam/given_charts.h"
#include "seam/part_in_work.h"

namespace abflat {

/// What a round of cuts has done.
struct CutRound {
  CutSurface surface;  ///< as it was before
  Seams seams;         ///< as they are now
  LogScales scale;     ///< expected before the round; empty if it was stopped, or failed
  IdVector<CutChartId, std::uint8_t> isChanged;
  std::uint32_t slits = 0, splits = 0;
  double solveSeconds = 0;

  std::size_t changedTriangles() const {
    std::size_t sum = 0;
    for (const CutChartId c : isChanged.ids())
      if (isChanged[c]) sum += surface.charts[c].triangles;
    return sum;
  }
};

/// Cuts each chart once more that is stretched too much, overlaps itself or has a bad shape.
CutRound cutRound(const PartInWork& part, const SeamOptions& options, const GivenCharts& given);

}  // namespace abflat
