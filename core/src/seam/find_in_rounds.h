#pragma once

#include <memory>
#include <vector>

#include "seam/extract_charts.h"
#include "seam/find_seams.h"
#include "seam/log_scale.h"

namespace abflat {

/// A search for the seams of a mesh half way: no chart needs to be cut, and charts are joined.
struct JoinedSeams {
  Seams seams;                           ///< marked on both sides
  Seams given;                           ///< those that must stay
  LogScales scale;                       ///< expected
  std::unique_ptr<const SeamPart> part;  ///< what has seams; null: the whole, or most of it
  std::unique_ptr<LogScale> solver;      ///< of the part; null once it is not needed
  EliminationRanks ranks;                ///< of the mesh
  std::vector<SurfaceCorner> doubled;    ///< see doubledEdges
  SeamSteps steps;
};

/// Cuts until no chart needs it, then joins charts. `given` seams are marked on both sides. The
/// mesh has to outlive the result.
JoinedSeams findJoined(const SeamMesh& mesh, Seams given, const SeamOptions& options);

/// Redraws seams and shortens them. They are marked on both sides.
Seams finishJoined(const SeamMesh& mesh, JoinedSeams joined, const SeamOptions& options,
                   SeamReport& report);

/// Both steps of a search.
Seams findInRounds(const SeamMesh& mesh, Seams given, const SeamOptions& options,
                   SeamReport& report);

}  // namespace abflat
