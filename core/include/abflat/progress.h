#pragma once

#include <functional>

namespace abflat {

/// Where a run is. `fraction` is a rough 0..1 for progress bars; Newton fields are 0 outside the
/// solve stage.
struct Progress {
  const char* stage = "";  ///< "connectivity", "solve", "layout", "check"
  int newtonStep = 0;
  double constraintResidual = 0;
  double fraction = 0;
};

/// Called often from the calling thread; return false to cancel (the run ends with
/// StatusCode::Aborted).
using ProgressCallback = std::function<bool(const Progress&)>;

}  // namespace abflat
