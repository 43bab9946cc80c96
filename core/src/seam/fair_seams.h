#pragma once

#include "seam/find_seams.h"
#include "seam/log_scale.h"

namespace abflat {

/// Draws seams anew where that makes them cheaper or straighter, as far as no chart goes beyond its
/// bounds for it. `kept` ones stay. `u` is the log-scale per vertex, before and after. True when
/// `scale` has last solved for the seams as they are now.
bool fairSeams(const SeamMesh& mesh, const Seams& kept, const SeamOptions& options, LogScale& scale,
               std::vector<double>& u, Seams& seams);

}  // namespace abflat
