#pragma once

#include <functional>
#include <string>
#include <vector>

#include "abflat/unwrap.h"
#include "base/parallel.h"
#include "chart/chart_set.h"
#include "mesh/surface_map.h"
#include "seam/find_seams.h"
#include "seam/scale_seams.h"
#include "unwrap/fixed.h"

namespace abflat {

/// A note that the surface is cut between two faces. `unit`: what a length of 1 is in the mesh.
std::string scaleNote(const ScaleJump& jump, const SurfaceMap& map, double unit);

/// The surface, its holes filled, with the seams that cut it to disks.
struct OpenSurface {
  SeamMesh mesh;
  double unit = 1;                                   ///< of `mesh`, in units of the input
  IdVector<SurfaceVertex, InputVertex> inputVertex;  ///< a vertex of the welded mesh
  Seams given;                                       ///< seams of the surface
  Seams seams;  ///< seams of `mesh`; given ones may be on its boundary instead
  Seams found;  ///< seams before they were shortened; a superset of `seams`
  EliminationRanks eliminationRanks;  ///< of `mesh`
  LogScales scale;                    ///< expected
  LogScales foundScale;               ///< expected, before seams were shortened
  Mirror mirror;                      ///< what the seams are symmetric to, if they are
  Asymmetry asymmetry = Asymmetry::None;
  int variant = 0;       ///< of the costs, where charts are cut further
  KnownSeams otherwise;  ///< to be used if symmetric seams are worse than expected
};

/// A surface before it is cut.
struct UncutSurface {
  const WeldedMesh& welded;
  double unit;  ///< of the welded mesh, in units of the input
  const Surface& surface;
  const FixedTriangles& fixed;  ///< what stays as it is
};

/// Where the surface has to be cut, whatever else is found.
struct AskedCuts {
  Seams seams;
  Seams breaks;  ///< as in SeamMesh, cut or not
  Scales scales;
  std::size_t upAxis = 1;
};

/// Which of several searches for seams it is.
struct SeamVariant {
  int costs = 0;                        ///< see varyCosts
  const OpenSurface* before = nullptr;  ///< what another search found; null: this is the first one
};

/// Cuts the surface around what is fixed, and fills the holes of its charts. `keepsOn` as in
/// SeamOptions.
OpenSurface cutOpen(const UncutSurface& uncut, const AskedCuts& asked, const SeamVariant& variant,
                    const UnwrapOptions& options, ThreadPool& pool,
                    const std::function<bool()>& keepsOn, SeamSummary& summary);

/// A note if seams should be symmetric, but are not; empty otherwise.
std::string asymmetryNote(const OpenSurface& open, const UnwrapOptions& options);

/// How flattening distorted a chart.
struct Stretched {
  double stretch = 0;      ///< above the limit, or of an invalid chart; 0: the chart stays as it is
  bool isInvalid = false;  ///< and has not been refined
};

/// What cutting further has done.
enum class Further : std::uint8_t {
  Nothing,  ///< none of the charts can be cut so that less stretch is expected
  Cut,
  Replaced  ///< the seams are others; charts that stay as they are have not been tried yet
};

/// Cuts charts further that are invalid or stretched by more than `options.maxStretch`. New seams
/// start from those found before, with a prediction corrected by the actual stretch.
Further cutStretched(const ChartSet& set, const IdVector<ChartId, Stretched>& charts,
                     const UnwrapOptions& options, ThreadPool& pool, std::function<bool()> keepsOn,
                     OpenSurface& open);

/// Splits charts in two, whatever is predicted, and adds those to `isWhole` that cannot be split.
/// False if none can be.
bool halve(const ChartSet& set, const IdVector<ChartId, std::uint8_t>& isAsked,
           const UnwrapOptionValues& options, OpenSurface& open,
           IdVector<ChartId, std::uint8_t>& isWhole);

/// Predicts the scale again for charts that seams have changed.
void expectScale(const ChartSet& set, const IdVector<ChartId, std::uint8_t>& isAsked,
                 ThreadPool& pool, OpenSurface& open);

ChartSet chartsOf(const WeldedMesh& welded, const OpenSurface& open);

/// All visible seams, including the given ones, per half-edge of the surface.
Seams visibleSeams(const OpenSurface& open);

/// Length of all visible seams, divided by the root of the area.
double seamLength(const OpenSurface& open);

/// The same for what they cost, see SeamMesh.
double seamCost(const OpenSurface& open);

/// Sets the number of seam edges and their length.
void measureSeams(const OpenSurface& open, const Seams& visible, SeamSummary& summary);
void measureSeams(const std::vector<double>& positions, const CornerTable& table,
                  const Seams& visible, SeamSummary& summary);

}  // namespace abflat
