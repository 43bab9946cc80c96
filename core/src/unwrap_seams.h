#pragma once

#include <functional>
#include <vector>

#include "abflat/unwrap.h"
#include "chart/chart_set.h"
#include "mesh/surface.h"
#include "mesh/welded_mesh.h"
#include "parallel.h"
#include "seam/scale_seams.h"
#include "unwrap_fixed.h"

namespace abflat {

/// The surface, its holes filled, with the seams that cut it to disks.
struct OpenSurface {
  SeamMesh mesh;
  std::vector<std::uint32_t> inputVertex;  ///< per vertex of `mesh`, of the welded mesh
  Seams given;                             ///< of the surface
  Seams seams;                             ///< of `mesh`; what is given may be its boundary instead
  std::vector<std::uint32_t> place;        ///< per vertex of `mesh`, in an elimination order
  std::vector<double> scale;               ///< per vertex of `mesh`, the log-scale to be expected
};

/// Cuts the surface around what is fixed, and fills the holes of its charts; `keepsOn` as in
/// SeamOptions.
OpenSurface cutOpen(const WeldedMesh& welded, const Surface& surface, const Seams& asked,
                    const Scales& scales, const FixedTriangles& fixed, const UnwrapOptions& options,
                    ThreadPool& pool, std::function<bool()> keepsOn, SeamSummary& summary);

/// Cuts charts further that flattening has stretched by more than `options.maxStretch`; `stretch`
/// is that per chart, 0 for those to be left as they are. False where none of them can be cut so
/// that less is to be expected.
bool cutStretched(const ChartSet& set, const std::vector<double>& stretch,
                  const UnwrapOptions& options, ThreadPool& pool, std::function<bool()> keepsOn,
                  OpenSurface& open);

/// Its charts.
ChartSet chartsOf(const WeldedMesh& welded, const OpenSurface& open);

/// The seams that can be seen, the given ones among them, per half-edge of the surface.
Seams visibleSeams(const OpenSurface& open);

/// Sets how many edges they have and how long they are.
void measureSeams(const OpenSurface& open, const Seams& visible, SeamSummary& summary);

}  // namespace abflat
