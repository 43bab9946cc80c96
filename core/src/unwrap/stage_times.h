#pragma once

#include "abflat/unwrap.h"
#include "base/stopwatch.h"

namespace abflat {

/// Books time on the stages of a run.
class StageTimes {
 public:
  explicit StageTimes(UnwrapStages& seconds) : seconds_(seconds) {}

  /// What has passed since the last call was spent on this stage.
  void book(double UnwrapStages::*stage) { seconds_.*stage += watch_.lap(); }

 private:
  UnwrapStages& seconds_;
  Stopwatch watch_;
};

}  // namespace abflat
