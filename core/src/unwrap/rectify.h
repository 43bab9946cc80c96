#pragma once

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "unwrap/laid_charts.h"

namespace abflat {

/// Makes outlines that are nearly straight lines exactly so where that stretches the chart by less
/// than the bound. Charts that are exact, pinned, given or asked to be straight stay as they are.
/// `unit`: that of the charts, in the mesh's.
void rectifyAll(const UnwrapOptions& options, double unit, ThreadPool& pool,
                const Listener& listener, LaidCharts& charts);

}  // namespace abflat
