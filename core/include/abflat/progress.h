#pragma once

#include <functional>
#include <optional>

#include "abflat/generated/names.h"

namespace abflat {

/// How far a run has got. `fraction` is a rough 0..1 for progress bars; Newton fields are 0 outside
/// the solve stage.
struct Progress {
  Stage stage = Stage::Read;
  int newtonStep = 0;
  double constraintResidual = 0;
  double fraction = 0;
  std::optional<MethodKey> method{};  ///< the one at work, in a comparison
};

/// The name of the method at work, or of the stage if there is no method.
inline const char* nameOf(const Progress& now) {
  return now.method ? nameOf(*now.method) : nameOf(now.stage);
}

/// Called often from the calling thread; return false to cancel (the run ends with
/// StatusCode::Aborted).
using ProgressCallback = std::function<bool(const Progress&)>;

}  // namespace abflat
