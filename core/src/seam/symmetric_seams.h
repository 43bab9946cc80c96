#pragma once

#include <optional>

#include "abflat/generated/unwrap_options.h"
#include "seam/extract_charts.h"
#include "seam/mirror.h"

namespace abflat {

/// Share of the seams' length whose image is a seam.
double mirroredShare(const SeamMesh& mesh, const Mirror& mirror, const Seams& seams);

/// The part on one side of the plane, as a surface of its own that is open along the plane; holes
/// that the plane touches are open as well. None if the plane would cut a polygon or a hole that
/// has to stay filled.
std::optional<SeamPart> halfOf(const SeamMesh& mesh, const Mirror& mirror, FillHoles mode);

/// The seams of the half and their mirror images, plus a cut along the plane.
Seams unfold(const SeamMesh& mesh, const Mirror& mirror, const SeamPart& half, const Seams& seams);

}  // namespace abflat
