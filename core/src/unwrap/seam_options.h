#pragma once

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// What finding seams is asked for. `listener` and `variant` as in SeamOptions.
SeamOptions seamOptions(const UnwrapOptions& options, const OpenSurface& open, ThreadPool& pool,
                        const Listener& listener, int variant = 0);

}  // namespace abflat
