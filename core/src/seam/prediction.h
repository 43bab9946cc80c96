#pragma once

#include <vector>

#include "cut/cut_surface.h"

namespace abflat {

/// What flattening will do to the charts, told from the log-scale, and from what it has done to
/// those that they were part of.
struct Prediction {
  /// Symmetric Dirichlet energy / 4 of a conformal map by area at equal total area: 1 is an
  /// isometry.
  IdVector<CutChartId, double> stretch;
  IdVector<CutChartId, double> meanScale;  ///< area-weighted mean of e^(2u)
  IdVector<CutChartId, double> excess;     ///< area-weighted mean of that of the mesh
  double total = 1;                        ///< mean of `stretch` by area
  /// A vertex's own stretch.
  double at(CutChartId chart, double u) const;
  /// How far its log-scale is from the chart's mean.
  double shift(CutChartId chart, double u) const;
};

/// What a vertex adds to the stretch of the triangles round it because their angles there grow to 2
/// pi. The finer the mesh the less area that is: 0 where it is a small share of the chart's, as
/// noise would count otherwise.
double kinkStretch(const SeamMesh& mesh, const CutSurface& surface, OpenVertex vertex);

Prediction predictStretch(const SeamMesh& mesh, const CutSurface& surface, const LogScales& u);

/// The stretch of a conformal layout that refining with the given balance turns into `stretch`, by
/// experience: of what is above 1 a share is left that depends little on the chart.
double stretchBeforeRefining(double stretch, double balance);

}  // namespace abflat
