#pragma once

#include "cut/cut_surface.h"

namespace abflat {

/// The charts of a mesh before a search has cut any of them.
class GivenCharts {
 public:
  explicit GivenCharts(const CutSurface& surface)
      : charts_(surface.charts), chartOfTriangle_(surface.chartOfTriangle) {}

  /// Whether a chart, which has `triangle` of the mesh, is still a disk as given, with all of its
  /// triangles and no edge used twice.
  bool isUntouched(const CutSurface::Chart& chart, SurfaceTriangle triangle) const {
    const CutSurface::Chart& given = charts_[chartOfTriangle_[triangle]];
    return given.isDisk() && given.triangles == chart.triangles && given.edges == chart.edges;
  }

 private:
  IdVector<CutChartId, CutSurface::Chart> charts_;
  IdVector<SurfaceTriangle, CutChartId> chartOfTriangle_;
};

}  // namespace abflat
