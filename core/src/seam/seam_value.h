#pragma once
#include <cstdlib>
#include <algorithm>
#include <cmath>

#include "cut/cut_surface.h"

namespace abflat {

/// What makes a layout worse, in terms of the length of seams in plain sight relative to the root
/// of the mesh's area.
struct SeamPrices {
  double stretch = getenv("X_RHO") ? atof(getenv("X_RHO")) : 0.2;
  double inexact = getenv("X_P") ? atof(getenv("X_P")) : 0.8;
  double chord = getenv("X_H") ? atof(getenv("X_H")) : 0.0;
  double chart = getenv("X_G") ? atof(getenv("X_G")) : 0.03;  ///< of a chart more

  /// Of a chart's conformal stretch, if the chart were the whole mesh.
  double ofStretch(double s) const {
    const double x = std::max(0.0, s - 1);
    return x / stretch + inexact * std::min(1.0, std::sqrt(x / 0.002));
  }
};

/// Per part of the mesh, what its seams cost, its charts and their stretch. `ofTriangle`: the part
/// of each triangle; no chart is in several parts.
IdVector<CutChartId, double> costOfParts(const SeamMesh& mesh, const Seams& seams,
                                         const LogScales& u, double maxStretch,
                                         const IdVector<SurfaceTriangle, CutChartId>& partOf,
                                         std::size_t parts, const SeamPrices& prices = {});

}  // namespace abflat
