#pragma once

#include <optional>

#include "seam/extract_charts.h"
#include "seam/mirror.h"

namespace abflat {

/// Share of the seams' length whose image is a seam.
double mirroredShare(const SeamMesh& mesh, const Mirror& mirror, const Seams& seams);

/// What is on one side of the plane, as a surface of its own that is open there. None where that
/// would cut a polygon or what fills a hole.
std::optional<SeamPart> halfOf(const SeamMesh& mesh, const Mirror& mirror);

/// Seams of the half and their images, with a cut along the plane.
Seams unfold(const SeamMesh& mesh, const Mirror& mirror, const SeamPart& half, const Seams& seams);

}  // namespace abflat
