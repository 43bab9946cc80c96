#pragma once

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "unwrap/open_and_fill.h"
#include "unwrap/seam_variant.h"

namespace abflat {

/// Cuts the surface around what is fixed, and fills the holes of its charts. `listener` as in
/// SeamOptions.
OpenSurface cutOpen(const UncutSurface& uncut, const AskedCuts& asked, const SeamVariant& variant,
                    const UnwrapOptions& options, ThreadPool& pool, const Listener& listener,
                    SeamSummary& summary);

}  // namespace abflat
