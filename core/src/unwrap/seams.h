#pragma once

#include <functional>
#include <string>
#include <vector>

#include "abflat/unwrap.h"
#include "base/parallel.h"
#include "chart/chart_set.h"
#include "mesh/surface_map.h"
#include "seam/scale_seams.h"
#include "unwrap/fixed.h"

namespace abflat {

/// That the surface is cut between two faces. `unit`: what a length of 1 is in the mesh.
std::string scaleNote(const ScaleJump& jump, const SurfaceMap& map, double unit);

/// The surface, its holes filled, with the seams that cut it to disks.
struct OpenSurface {
  SeamMesh mesh;
  double unit = 1;                                   ///< of `mesh`, in that of the input
  IdVector<SurfaceVertex, InputVertex> inputVertex;  ///< of the welded mesh
  Seams given;                                       ///< of the surface
  Seams seams;                        ///< of `mesh`; what is given may be its boundary instead
  Seams found;                        ///< before they were shortened; a superset of `seams`
  EliminationRanks eliminationRanks;  ///< of `mesh`
  LogScales scale;                    ///< to be expected
  LogScales foundScale;               ///< the same before seams were shortened
};

/// A surface before it is cut.
struct UncutSurface {
  const WeldedMesh& welded;
  double unit;  ///< of the welded mesh, in that of the input
  const Surface& surface;
};

/// Where it is to be cut, whatever else is found.
struct AskedCuts {
  const Seams& seams;
  const Scales& scales;
  const FixedTriangles& fixed;
};

/// Cuts the surface around what is fixed, and fills the holes of its charts; `keepsOn` as in
/// SeamOptions.
OpenSurface cutOpen(const UncutSurface& uncut, const AskedCuts& asked, const UnwrapOptions& options,
                    ThreadPool& pool, std::function<bool()> keepsOn, SeamSummary& summary);

/// What flattening has made of a chart.
struct Stretched {
  double stretch = 0;      ///< above what is allowed, or tangled; 0: it is to stay as it is
  bool isTangled = false;  ///< its boundary crosses itself, so it has not been refined
};

/// Cuts charts further that are stretched by more than `options.maxStretch`, or tangled: their
/// seams are found anew, from those that were found before, with a prediction that what they are
/// tells better. False where none of them can be cut so that less is to be expected.
bool cutStretched(const ChartSet& set, const IdVector<ChartId, Stretched>& charts,
                  const UnwrapOptions& options, ThreadPool& pool, std::function<bool()> keepsOn,
                  OpenSurface& open);

/// Tells anew which scale is to be expected of charts that seams have changed.
void expectScale(const ChartSet& set, const IdVector<ChartId, std::uint8_t>& isAsked,
                 ThreadPool& pool, OpenSurface& open);

/// Its charts.
ChartSet chartsOf(const WeldedMesh& welded, const OpenSurface& open);

/// The seams that can be seen, the given ones among them, per half-edge of the surface.
Seams visibleSeams(const OpenSurface& open);

/// Of all that can be seen, over the root of the area.
double seamLength(const OpenSurface& open);

/// Sets how many edges they have and how long they are.
void measureSeams(const OpenSurface& open, const Seams& visible, SeamSummary& summary);

}  // namespace abflat
