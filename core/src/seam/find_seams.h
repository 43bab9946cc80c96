#pragma once

#include <limits>
#include <vector>

#include "abflat/generated/unwrap_options.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "cut/cut_surface.h"
#include "seam/mirror.h"
#include "seam/seam_value.h"

namespace abflat {

struct SeamOptions {
  bool isAuto = true;  ///< false: only what topology needs
  /// Bound on a chart's predicted symmetric Dirichlet energy / 4; 1 is an isometry.
  double maxStretch = 1.04;
  Seams first;  ///< to start with, besides the given ones; empty: none
  /// Least share of its convex hull that a chart has to fill once it has been cut.
  double leastFill = 0.5;
  /// Share of a chart that its predicted layout may cover twice.
  double mostOverlap = 0.0003;
  /// The longest that a chart may be, in the mesh's unit; infinite: no limit.
  double longest = std::numeric_limits<double>::infinity();
  /// Charts that reach no farther, in the mesh's unit, take up less of the atlas joined than apart,
  /// however little of their hull they fill: the padding around them is what counts.
  double speck = 0;
  EliminationRanks eliminationRanks;  ///< as in SeamReport; empty: they are computed
  SeamPrices prices;
  int variant = 0;  ///< of the costs, see varyCosts
  Mirror mirror;    ///< what seams are kept symmetric to, where they can be; none: nothing
  SymmetricSeams symmetricSeams = SymmetricSeams::Auto;
  FillHoles fillHoles = FillHoles::Auto;  ///< when a hole that is filled in the mesh may be opened
  ThreadPool* pool = nullptr;             ///< results do not depend on it; null: one thread
  Listener listener;  ///< once it has stopped: the seams so far, which still cut to disks
};

/// Why seams are not symmetric, unless others are preferable.
enum class Asymmetry : std::uint8_t {
  None,
  NoPlane,     ///< the mesh is not its own mirror image
  NoSeams,     ///< those found do not stay symmetric within the bounds on stretch and overlap
  SeamsGiven,  ///< there were seams before
};

/// Seams, and the scale expected for them.
struct KnownSeams {
  Seams seams, found;  ///< now, and before they were shortened
  LogScales scale, foundScale;
};

/// What a search did, and how long its steps took.
struct SeamSteps {
  int rounds = 0;
  std::uint32_t slits = 0, splits = 0, merges = 0;
  std::uint32_t handleLoops = 0;
  double handleLength = 0;  ///< of the seams required by the topology, over sqrt(surface area)
  double analysisSeconds = 0, solveSeconds = 0, mergeSeconds = 0;
};

struct SeamReport : SeamSteps {
  std::uint32_t charts = 0;
  double seamLength = 0;              ///< in 3D, over sqrt(surface area)
  double stretch = 1;                 ///< predicted, area-weighted mean
  EliminationRanks eliminationRanks;  ///< of the mesh
  Seams found;                        ///< the seams before they were shortened
  LogScales foundScale;               ///< `scale` before shortening
  LogScales scale;                    ///< expected log-scale
  double seconds = 0;                 ///< all of it
  Mirror mirror;                      ///< what symmetric seams are symmetric to
  KnownSeams otherwise;               ///< the seams that symmetric ones were preferred to
  Asymmetry asymmetry = Asymmetry::None;
};

/// `given` seams are kept. Afterwards every chart is a topological disk, counting hole fillings;
/// rims of holes that were opened again are marked like seams.
Seams findSeams(const SeamMesh& mesh, Seams given, const SeamOptions& options, SeamReport* report);

}  // namespace abflat
