#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "seam/extract_charts.h"
#include "seam/prediction.h"
#include "seam/seam_work.h"
#include "seam/shared_runs.h"

namespace abflat {

/// Charts joined to see what comes of it, on a surface of its own, or on the whole surface if that
/// is mostly what is joined.
class MergeTrial {
 public:
  /// `all` are no seams any more in work.seams. `apart`: the surface before that; none afterwards
  /// if the trial is on the whole surface.
  MergeTrial(const SeamWork& work, const std::vector<RunsTogether>& all,
             std::optional<CutSurface>& apart, const Listener& listener);

  const SeamMesh& mesh() const { return part_ ? part_->mesh : *whole_; }
  const CutSurface& joined() const { return joined_; }
  const CutSurface& apart() const { return apart_; }
  const LogScales& scale() const { return u_; }  ///< of the joined surface; empty if unknown
  double stretchOf(CutChartId joined) const { return told_.stretch[joined]; }
  double stretchApart(CutChartId apart) const { return before_.stretch[apart]; }

  CutChartId joinedAt(const SharedRun& run) const {
    return joined_.chartOf(inTrial(run.edges.front()));
  }
  /// The charts that the runs join.
  std::vector<CutChartId> partsOf(const RunsTogether& runs) const;
  SurfaceVertex inWhole(SurfaceVertex v) const { return part_ ? part_->wholeVertex[v] : v; }

 private:
  SurfaceCorner inTrial(SurfaceCorner h) const;
  void tryWhole(const SeamWork& work, CutSurface joined, CutSurface apart);
  void tryPart(const SeamWork& work, const std::vector<SharedRun>& runs, CutSurface& apart,
               const IdVector<CutChartId, std::uint8_t>& isJoined, const Listener& listener);

  const SeamMesh* whole_;
  std::unique_ptr<SeamPart> part_;  ///< null: the whole
  CutSurface joined_, apart_;
  LogScales u_;
  Prediction told_, before_;  ///< joined, apart
};

}  // namespace abflat
