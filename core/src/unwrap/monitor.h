#pragma once

#include <atomic>

#include "abflat/unwrap.h"

namespace abflat {

/// Where the stages are in the progress bar.
struct Stage {
  const char* name;
  double from, to;
  double UnwrapStages::*field;
};
inline constexpr Stage kSurface{"surface", 0, 0.05, &UnwrapStages::surface},
    kSeams{"seams", 0.05, 0.2, &UnwrapStages::seams},
    kSolve{"solve", 0.2, 0.85, &UnwrapStages::solve},
    kPack{"pack", 0.85, 0.97, &UnwrapStages::pack}, kCheck{"check", 0.97, 1, &UnwrapStages::check};

class Monitor {
 public:
  explicit Monitor(const ProgressCallback& callback) : callback_(callback) {}

  /// False when the run is to end. `share` of the stage is done.
  bool tell(const Stage& stage, double share = 0) {
    Progress now;
    now.stage = stage.name;
    now.fraction = stage.from + share * (stage.to - stage.from);
    last_ = now;
    return tellAgain();
  }
  /// The same once more: the work goes on.
  bool tellAgain() {
    if (callback_ && !stopped_ && !callback_(last_)) stopped_ = true;
    return !stopped_;
  }
  bool stopped() const { return stopped_; }

 private:
  const ProgressCallback& callback_;
  Progress last_;
  std::atomic<bool> stopped_{false};
};

}  // namespace abflat
