#pragma once

#include <vector>

#include "cut/cut_surface.h"

namespace abflat {

/// What flattening will do to the charts, predicted from the log-scale and from what it did to the
/// charts that they were part of.
struct Prediction {
  /// Symmetric Dirichlet energy / 4 of a conformal map, by area at equal total area: 1 is an
  /// isometry.
  IdVector<CutChartId, double> stretch;
  IdVector<CutChartId, double> leeway;     ///< area-weighted mean; `stretch` - 1 is over it
  IdVector<CutChartId, double> meanScale;  ///< area-weighted mean of e^(2u)
  IdVector<CutChartId, double> excess;     ///< area-weighted mean of the mesh's, over the leeway
  double total = 1;                        ///< area-weighted mean of `stretch`
  /// The stretch at a single vertex.
  double at(CutChartId chart, double u) const;
  /// How far its log-scale is from the chart's mean.
  double shift(CutChartId chart, double u) const;
};

/// What a vertex adds to the stretch of the triangles around it because their angles there grow to
/// a sum of 2 pi. The finer the mesh, the less area that affects: it is 0 if the area is a small
/// share of the chart's, since noise would count otherwise.
double kinkStretch(const SeamMesh& mesh, const CutSurface& surface, OpenVertex vertex);

Prediction predictStretch(const SeamMesh& mesh, const CutSurface& surface, const LogScales& u);

}  // namespace abflat
