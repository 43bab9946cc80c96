#pragma once

#include "seam/find_seams.h"

namespace abflat {

/// Takes seams back from where they end, as far as the bound allows: those first that a chart's
/// stretch depends on least for their length. `kept` are seams that stay, `place` an elimination
/// order of the whole, `u` the log-scale of the charts as they are, and then as they have become.
void shortenSeams(const SeamMesh& mesh, const Seams& kept, const SeamOptions& options,
                  const std::vector<std::uint32_t>& place, std::vector<double>& u, Seams& seams);

}  // namespace abflat
