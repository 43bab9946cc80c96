#pragma once

#include "abflat/unwrap.h"
#include "base/listener.h"

namespace abflat {

/// The part of the progress bar that a stage takes.
struct StageSpan {
  Stage stage;
  double from, to;
  double UnwrapStages::*field;

  Listener of(const Listener& run) const { return run.part(stage, from, to); }
};
inline constexpr StageSpan kSurface{Stage::Surface, 0, 0.05, &UnwrapStages::surface},
    kSeams{Stage::Seams, 0.05, 0.5, &UnwrapStages::seams},
    kSolve{Stage::Solve, 0.5, 0.88, &UnwrapStages::solve},
    kPack{Stage::Pack, 0.88, 0.97, &UnwrapStages::pack},
    kCheck{Stage::Check, 0.97, 1, &UnwrapStages::check};

}  // namespace abflat
