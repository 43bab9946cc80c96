#pragma once

#include <memory>

#include "seam/extract_charts.h"

namespace abflat {

/// The components of a mesh that have a seam, as a mesh of their own. Null if that is most of the
/// mesh, so that it would gain little.
std::unique_ptr<const SeamPart> componentsWithSeams(const SeamMesh& mesh, const Seams& seams,
                                                    const Listener& listener);

}  // namespace abflat
