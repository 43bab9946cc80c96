// The functions that JavaScript calls of the main module, besides those of input_api.cpp, where
// sizes and pointers are explained.

#include <emscripten/emscripten.h>

#include "abflat/samples.h"
#include "buffers.h"
#include "callbacks.h"
#include "generated/unwrap_array.h"
#include "job.h"

using abflat::Precision;
using abflat::StatusCode;
using abflat::bindings::Field;
using abflat::bindings::finish;
using abflat::bindings::Job;
using abflat::bindings::kFirstFile;
using abflat::bindings::resized;
using abflat::bindings::tellProgress;
using abflat::bindings::UnwrapArray;

extern "C" {

EMSCRIPTEN_KEEPALIVE Job* abflatNewJob() { return abflat::bindings::newJob<Job>(); }

EMSCRIPTEN_KEEPALIVE void abflatFreeJob(Job* job) { delete job; }

/// Sets flattening option number `index`, in the order of FLATTEN_OPTIONS, to a number.
EMSCRIPTEN_KEEPALIVE int abflatSetOption(Job* job, int index, double value) {
  return setNumber(*job, job->options, index, value);
}

/// The same for unwrapping, in the order of UNWRAP_OPTIONS.
EMSCRIPTEN_KEEPALIVE int abflatSetUnwrapOption(Job* job, int index, double value) {
  return setNumber(*job, job->unwrapOptions, index, value);
}

/// Buffer for the seam sources, as text for parseSeams, `size` bytes.
EMSCRIPTEN_KEEPALIVE char* abflatSeams(Job* job, std::size_t size) {
  job->seams.resize(size);
  return job->seams.data();
}

/// Buffer for an array among the options of unwrap, `size` numbers; UnwrapArray says which.
EMSCRIPTEN_KEEPALIVE void* abflatArray(Job* job, int array, std::size_t size) {
  return takeArray(job->unwrapOptions, static_cast<UnwrapArray>(array),
                   [size](auto& numbers) -> void* { return resized(numbers, size); });
}

/// Makes all faces that have texcoords keep them.
EMSCRIPTEN_KEEPALIVE void abflatKeepUv(Job* job) { job->keepsUv = true; }

/// Unwraps islands that cannot keep their texcoords, instead of an error.
EMSCRIPTEN_KEEPALIVE void abflatKeepsValidOnly(Job* job) {
  job->unwrapOptions.reuse.keepsValidOnly = true;
}

/// Makes known charts stay where they are.
EMSCRIPTEN_KEEPALIVE void abflatKeepsPlaces(Job* job) {
  job->unwrapOptions.reuse.keepsPlaces = true;
}

/// Buffer for an array of a known layout, `size` numbers; Field says which.
EMSCRIPTEN_KEEPALIVE void* abflatKnown(Job* job, int field, std::size_t size) {
  return knownRoom(*job, static_cast<Field>(field), size);
}

/// The options that the known layout was made with.
EMSCRIPTEN_KEEPALIVE void abflatKnownOptions(Job* job, double t, double balance,
                                             bool straightSeams) {
  job->unwrapOptions.reuse.known.t = t;
  job->unwrapOptions.reuse.known.balance = balance;
  job->unwrapOptions.reuse.known.straightSeams = straightSeams;
}

/// Moves and scales a flattened mesh into the unit square.
EMSCRIPTEN_KEEPALIVE void abflatNormalizes(Job* job) { job->normalizes = true; }

EMSCRIPTEN_KEEPALIVE void abflatAddBound(Job* job, std::uint32_t vertex, double t) {
  job->options.bounds.push_back({vertex, t});
}

EMSCRIPTEN_KEEPALIVE void abflatAddStraight(Job* job, std::uint32_t from, std::uint32_t to) {
  job->options.straight.push_back({from, to});
}

/// Adds a pin, whichever kind of job follows; `face` is 2^32 - 1 if none is given.
EMSCRIPTEN_KEEPALIVE void abflatAddPin(Job* job, std::uint32_t vertex, double u, double v,
                                       std::uint32_t face) {
  const abflat::Pin pin{vertex, {u, v}, face};
  job->options.pins.push_back(pin);
  job->unwrapOptions.pins.push_back(pin);
}

/// `files` has a bit for each Field that is a file to write; `roundsForGltf` rounds texcoords to
/// what a glTF can hold.
EMSCRIPTEN_KEEPALIVE int abflatFlatten(Job* job, unsigned files, bool roundsForGltf) {
  job->unwrapOptions.precision = roundsForGltf ? Precision::Gltf : Precision::Double;
  return finish(*job, flattenJob(*job, files >> kFirstFile, tellProgress));
}

/// The same for unwrapping.
EMSCRIPTEN_KEEPALIVE int abflatUnwrap(Job* job, unsigned files, bool roundsForGltf) {
  job->unwrapOptions.precision = roundsForGltf ? Precision::Gltf : Precision::Double;
  return finish(*job, unwrapJob(*job, files >> kFirstFile, tellProgress));
}

EMSCRIPTEN_KEEPALIVE int abflatCompare(Job* job) {
  return finish(*job, compareJob(*job, tellProgress));
}

/// How the layout in the mesh's texcoords follows the first pin.
EMSCRIPTEN_KEEPALIVE int abflatPinWeights(Job* job) { return finish(*job, pinWeightsJob(*job)); }

EMSCRIPTEN_KEEPALIVE int abflatInspect(Job* job) { return finish(*job, inspectJob(*job)); }

EMSCRIPTEN_KEEPALIVE int abflatLoad(Job* job) { return finish(*job, loadJob(*job)); }

EMSCRIPTEN_KEEPALIVE int abflatSample(Job* job, double detail) {
  return finish(*job, sampleJob(*job, detail));
}

/// The layout by method number `method` of a comparison.
EMSCRIPTEN_KEEPALIVE const void* abflatMethodUvData(const Job* job, int method) {
  return methodUvOf(*job, static_cast<std::size_t>(method)).data;
}

/// Size in bytes.
EMSCRIPTEN_KEEPALIVE std::size_t abflatMethodUvSize(const Job* job, int method) {
  return methodUvOf(*job, static_cast<std::size_t>(method)).size;
}

/// The names are those of BUILDS in builds.ts.
EMSCRIPTEN_KEEPALIVE const char* abflatBuild() {
#if ABFLAT_THREADS
  return "threads";
#else
  return "simd";
#endif
}

EMSCRIPTEN_KEEPALIVE int abflatStatusCount() { return abflat::kStatusCodeCount; }

EMSCRIPTEN_KEEPALIVE const char* abflatStatusName(int code) {
  return abflat::statusName(static_cast<StatusCode>(code));
}

EMSCRIPTEN_KEEPALIVE int abflatSampleCount() { return static_cast<int>(abflat::samples().size()); }

/// The name, terminated by a zero byte as every string literal is.
EMSCRIPTEN_KEEPALIVE const char* abflatSampleName(int index) {
  return abflat::samples()[static_cast<std::size_t>(index)].name.data();
}

}  // extern "C"
