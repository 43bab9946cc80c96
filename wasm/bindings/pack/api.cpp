// The functions that JavaScript calls of the module that packs layouts, besides those of
// input_api.cpp.

#include <emscripten/emscripten.h>

#include <new>

#include "callbacks.h"
#include "pack_job.h"

using abflat::Precision;
using abflat::bindings::finish;
using abflat::bindings::Job;
using abflat::bindings::kFirstFile;
using abflat::bindings::tellProgress;

extern "C" {

EMSCRIPTEN_KEEPALIVE Job* abflatNewJob() {
  // Without exceptions a failed allocation would just abort the module.
  std::set_new_handler(abflat::bindings::outOfMemory);
  return new Job;
}

EMSCRIPTEN_KEEPALIVE void abflatFreeJob(Job* job) { delete job; }

/// Sets option number `index` of packing a layout, in the order of PACK_OPTIONS, to a number.
EMSCRIPTEN_KEEPALIVE int abflatSetPackOption(Job* job, int index, double value) {
  return setNumber(*job, job->packOptions, index, value);
}

/// Packs the layout that the mesh has. `files` has a bit for each Field that is a file to write;
/// `roundsForGltf` rounds texcoords to what a glTF can hold.
EMSCRIPTEN_KEEPALIVE int abflatPack(Job* job, unsigned files, bool roundsForGltf) {
  job->packOptions.precision = roundsForGltf ? Precision::Gltf : Precision::Double;
  return finish(*job, packJob(*job, files >> kFirstFile, tellProgress));
}

}  // extern "C"
