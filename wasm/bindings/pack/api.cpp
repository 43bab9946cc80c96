// The functions that JavaScript calls of the module that packs and verifies layouts, besides those
// of input_api.cpp.

#include <emscripten/emscripten.h>

#include <cstddef>
#include <cstdint>

#include "buffers.h"
#include "callbacks.h"
#include "pack_job.h"
#include "verify_job.h"

using abflat::Precision;
using abflat::bindings::finish;
using abflat::bindings::Job;
using abflat::bindings::kFirstFile;
using abflat::bindings::resized;
using abflat::bindings::tellProgress;

extern "C" {

EMSCRIPTEN_KEEPALIVE Job* abflatNewJob() { return abflat::bindings::newJob<Job>(); }

EMSCRIPTEN_KEEPALIVE void abflatFreeJob(Job* job) { delete job; }

/// Sets option number `index` of packing a layout, in the order of PACK_OPTIONS, to a number.
EMSCRIPTEN_KEEPALIVE int abflatSetPackOption(Job* job, int index, double value) {
  return setNumber(*job, job->packOptions, index, value);
}

/// The same for verifying one, in the order of VERIFY_OPTIONS.
EMSCRIPTEN_KEEPALIVE int abflatSetVerifyOption(Job* job, int index, double value) {
  return setNumber(*job, job->verifyOptions, index, value);
}

/// Buffer for coordinates in place of the texcoords of the mesh, two per corner of its triangles.
EMSCRIPTEN_KEEPALIVE double* abflatTriangleUv(Job* job, std::size_t size) {
  return resized(job->triangleUv, size);
}

/// Buffer for the islands that are packed around the others.
EMSCRIPTEN_KEEPALIVE std::uint32_t* abflatPackedIslands(Job* job, std::size_t size) {
  return resized(job->packOptions.islands, size);
}

/// Buffer for the tile that each island goes to.
EMSCRIPTEN_KEEPALIVE std::uint32_t* abflatIslandTiles(Job* job, std::size_t size) {
  return resized(job->packOptions.tileOfIsland, size);
}

/// Packs the layout that the mesh has. `files` has a bit for each Field that is a file to write;
/// `roundsForGltf` rounds texcoords to what a glTF can hold.
EMSCRIPTEN_KEEPALIVE int abflatPack(Job* job, unsigned files, bool roundsForGltf) {
  job->packOptions.precision = roundsForGltf ? Precision::Gltf : Precision::Double;
  return finish(*job, packJob(*job, files >> kFirstFile, tellProgress));
}

/// Verifies the layout that the mesh has.
EMSCRIPTEN_KEEPALIVE int abflatVerify(Job* job) {
  return finish(*job, verifyJob(*job, tellProgress));
}

}  // extern "C"
