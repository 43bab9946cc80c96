#pragma once

#include "pack_job.h"

namespace abflat::bindings {

/// Fills the report of the layout that the mesh has as text, the island of each face, and the face
/// and the faults of each triangle.
Status verifyJob(Job& job, const ProgressCallback& progress);

}  // namespace abflat::bindings
