#pragma once

#include "cut/cut_surface.h"
#include "seam/prediction.h"

namespace abflat {

/// What makes seams bad, in terms of the length of a seam in plain sight. Lengths are relative to
/// the root of the area.
struct SeamPrices {
  double chart = 0.03;      ///< of a chart more
  double stretch = 5;       ///< of the conformal stretch of a chart, for what it exceeds 1 by
  double inexact = 0.8;     ///< of a chart that is not exact, so that nearly free seams are taken
  double anyInexact = 0.8;  ///< of a component with such a chart: what unrolls comes out exact
  double unseen = 0.6;      ///< saved where the surface sees nothing but itself
  double ofStretch(double stretch) const;
  /// Only lengths count.
  static SeamPrices none() { return {0, 0, 0, 0, 0}; }
};

/// What seams cost, in the mesh's unit.
double costOfSeams(const SeamMesh& mesh, const Seams& seams);

/// What seams and the stretch of charts cost in all, but not the number of charts.
double costOfAll(const SeamMesh& mesh, const Seams& seams, const CutSurface& surface,
                 const Prediction& told, const SeamPrices& prices);

/// Per part of the mesh, what its seams, charts and stretch cost, relative to its own size.
/// `partOf`: the part of each triangle; no chart is in several parts. A chart above `maxStretch`
/// costs a multiple.
IdVector<CutChartId, double> costOfParts(const SeamMesh& mesh, const Seams& seams,
                                         const LogScales& u, double maxStretch,
                                         const IdVector<SurfaceTriangle, CutChartId>& partOf,
                                         std::size_t parts, const SeamPrices& prices);

/// The same for the whole mesh as one part.
double costOfWhole(const SeamMesh& mesh, const Seams& seams, const LogScales& u, double maxStretch,
                   const SeamPrices& prices);

}  // namespace abflat
