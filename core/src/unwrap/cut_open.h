#pragma once

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "unwrap/open_and_fill.h"

namespace abflat {

/// Which of several searches for seams it is.
struct SeamVariant {
  int costs = 0;                        ///< see varyCosts
  const OpenSurface* before = nullptr;  ///< what another search found; null: this is the first one
};

/// Cuts the surface around what is fixed, and fills the holes of its charts. `listener` as in
/// SeamOptions.
OpenSurface cutOpen(const UncutSurface& uncut, const AskedCuts& asked, const SeamVariant& variant,
                    const UnwrapOptions& options, ThreadPool& pool, const Listener& listener,
                    SeamSummary& summary);

}  // namespace abflat
