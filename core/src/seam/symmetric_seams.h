#pragma once

#include <optional>

#include "abflat/generated/unwrap_options.h"
#include "seam/extract_charts.h"
#include "seam/mirror.h"

namespace abflat {

/// Of the length of the seams that have an image, the share whose image is a seam.
double mirroredShare(const SeamMesh& mesh, const Mirror& mirror, const Seams& seams);

/// The part on one side of the plane, as a surface of its own that is open along the plane; holes
/// that the plane touches are open as well. None if there are no planeSeams().
std::optional<SeamPart> halfOf(const SeamMesh& mesh, const Mirror& mirror, FillHoles mode);

/// The seams of the half and their mirror images, plus a cut along the plane.
Seams unfold(const SeamMesh& mesh, const Mirror& mirror, const SeamPart& half, const Seams& seams);

/// The edges between the two sides of the plane, as seams; none if some of them must not be cut.
std::optional<Seams> planeSeams(const SeamMesh& mesh, const Mirror& mirror);

/// The seams with those on one side of the plane, 1 or -1, replaced by images of those on the other
/// one. Seams without an image stay.
Seams mirrored(const SeamMesh& mesh, const Mirror& mirror, const Seams& seams, int from);

}  // namespace abflat
