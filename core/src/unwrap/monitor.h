#pragma once

#include <atomic>

#include "abflat/unwrap.h"

namespace abflat {

/// The part of the progress bar that a stage takes.
struct StageSpan {
  Stage stage;
  double from, to;
  double UnwrapStages::*field;
};
inline constexpr StageSpan kSurface{Stage::Surface, 0, 0.05, &UnwrapStages::surface},
    kSeams{Stage::Seams, 0.05, 0.5, &UnwrapStages::seams},
    kSolve{Stage::Solve, 0.5, 0.88, &UnwrapStages::solve},
    kPack{Stage::Pack, 0.88, 0.97, &UnwrapStages::pack},
    kCheck{Stage::Check, 0.97, 1, &UnwrapStages::check};

/// The share done of work whose amount is unknown. It comes ever closer to 1, and passes one half
/// after `usual` steps.
class Approach {
 public:
  explicit Approach(double usual) : usual_(usual) {}
  double next() {
    ++steps_;
    return steps_ / (steps_ + usual_);
  }

 private:
  const double usual_;
  double steps_ = 0;
};

class Monitor {
 public:
  explicit Monitor(const ProgressCallback& callback) : callback_(callback) {}

  /// Reports that `share` of the stage is done. Returns false if the run is to end.
  bool tell(const StageSpan& span, double share = 0) {
    Progress now;
    now.stage = span.stage;
    now.fraction = span.from + share * (span.to - span.from);
    last_ = now;
    return tellAgain();
  }
  /// Repeats the last report, to show that work goes on.
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
