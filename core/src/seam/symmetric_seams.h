#pragma once

#include <vector>

#include "cut/cut_surface.h"
#include "seam/mirror.h"

namespace abflat {

/// Of the length of the seams that have an image, the share whose image is a seam.
double mirroredShare(const SeamMesh& mesh, const Mirror& mirror, const Seams& seams);

/// The seams with those on one side of the plane, 1 or -1, replaced by images of those on the other
/// one. Seams without an image stay.
Seams mirrored(const SeamMesh& mesh, const Mirror& mirror, const Seams& seams, int from);

/// Cuts charts that are their own images along the plane, if their area is less than `broadest` of
/// the square of its length in them: narrow ones lie between a seam beside the plane and its image,
/// which can be joined to one in the plane.
void cutAlongPlane(const SeamMesh& mesh, const Mirror& mirror, double broadest, Seams& seams);

/// Marks the images of what `seams` have more than `before`, if that leaves disks. Returns what was
/// marked, on both sides.
std::vector<SurfaceCorner> addImages(const SeamMesh& mesh, const Mirror& mirror,
                                     const Seams& before, Seams& seams, const Listener& listener);

}  // namespace abflat
