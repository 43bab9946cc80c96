#pragma once

#include "seam/find_seams.h"
#include "seam/log_scale.h"

namespace abflat {

/// Takes seams back from where they end, as far as the bound allows: those first that a chart's
/// stretch depends on least for their length. `kept` are seams that stay, `scale` is that of the
/// whole, whatever it has been solved for, `u` the log-scale of the charts as they are, and then as
/// they have become. `isSolved`: that is what `scale` has last solved for.
void shortenSeams(const SeamMesh& mesh, const Seams& kept, const SeamOptions& options,
                  LogScale& scale, std::vector<double>& u, Seams& seams, bool isSolved = false);

}  // namespace abflat
