#pragma once

#include <vector>

#include "abflat/pack_layout.h"
#include "abflat/verify.h"
#include "layout_job.h"

namespace abflat::bindings {

/// One call of the module for layouts that a mesh has.
struct Job : InputJob {
  PackLayoutOptions packOptions;
  VerifyOptions verifyOptions;
  /// 2 per corner of a triangle, in place of the texcoords of the mesh; empty: those.
  std::vector<double> triangleUv;
};

/// Fills everything that resultOf() returns for the layout that the mesh has, packed, and rounded
/// as the options and choosePrecision() say. What is known of the charts is that of the islands.
Status packJob(Job& job, WantedFiles wanted, const ProgressCallback& progress);

}  // namespace abflat::bindings
