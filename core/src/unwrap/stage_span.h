#pragma once

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "unwrap/passes.h"

namespace abflat {

/// The part of the progress bar that a stage takes; seams and layouts take turns, see Passes.
struct StageSpan {
  Stage stage;
  double from, to;
  double UnwrapStages::*field;

  Listener of(const Listener& run) const { return run.part(stage, from, to); }
};
inline constexpr StageSpan kSurface{Stage::Surface, 0, Passes::kFrom, &UnwrapStages::surface},
    kSeams{Stage::Seams, Passes::kFrom, Passes::kTo, &UnwrapStages::seams},
    kSolve{Stage::Solve, Passes::kFrom, Passes::kTo, &UnwrapStages::solve},
    kPack{Stage::Pack, Passes::kTo, 0.96, &UnwrapStages::pack},
    kCheck{Stage::Check, 0.96, 1, &UnwrapStages::check};

}  // namespace abflat
