#pragma once

#include <functional>

#include "abflat/unwrap.h"
#include "base/parallel.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// What finding seams is asked for. `keepsOn` and `variant` as in SeamOptions.
SeamOptions seamOptions(const UnwrapOptions& options, const OpenSurface& open, ThreadPool& pool,
                        std::function<bool()> keepsOn, int variant = 0);

}  // namespace abflat
