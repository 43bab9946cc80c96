#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "abflat/compare.h"
#include "abflat/flatten.h"
#include "abflat/unwrap.h"
#include "layout_job.h"

namespace abflat::bindings {

/// One call of the main module.
struct Job : InputJob {
  FlattenOptions options;
  UnwrapOptions unwrapOptions;
  std::string seams = "auto";  ///< as for parseSeams; edges are in unwrapOptions
  bool keepsUv = false;     ///< all faces with texcoords are fixed, besides those in unwrapOptions
  bool normalizes = false;  ///< a flattened mesh is moved and scaled into the unit square
  std::vector<MethodResult> methods;  ///< of a comparison
};

/// The layout by one method of a comparison, in the order of its JSON; empty if there is none.
Bytes methodUvOf(const Job& job, std::size_t method);

/// Buffer for one of the arrays of a known layout: Uv, Unpacked, Indices, VertexMap or
/// ChartOfTriangle.
void* knownRoom(Job& job, Field field, std::size_t size);

/// Fills everything that resultOf() returns for a layout, normalized and rounded as the job says.
/// `progress` as in FlattenOptions, plus the stages Read and Write.
Status flattenJob(Job& job, WantedFiles wanted, const ProgressCallback& progress);

/// The same for unwrapping; `progress` as in UnwrapOptions. Texcoords are rounded to what a glTF
/// holds if the options say so, otherwise as choosePrecision() says.
Status unwrapJob(Job& job, WantedFiles wanted, const ProgressCallback& progress);

/// Fills everything that resultOf() returns except uv, and job.methods. `progress` as in
/// CompareOptions, plus the stage Read.
Status compareJob(Job& job, const ProgressCallback& progress);

Status inspectJob(Job& job);

/// Returns the weights of the vertices as uv. The mesh comes as arrays, with the layout as
/// texcoords; only the vertices of the pins count.
Status pinWeightsJob(Job& job);

/// Returns the triangles of the input, whatever its topology.
Status loadJob(Job& job);

/// Makes the sample called job.name. Errors: InvalidOption, listing the available names.
Status sampleJob(Job& job, double detail);

}  // namespace abflat::bindings
