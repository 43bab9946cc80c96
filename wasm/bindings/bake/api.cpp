// The functions of the module abflat-bake that JavaScript calls. Sizes are in elements; pointers
// are valid until the job is freed.

#include <emscripten/emscripten.h>

#include "bake/bake_job.h"
#include "buffers.h"
#include "callbacks.h"

using abflat::bindings::BakeJob;
using abflat::bindings::ImageKind;
using abflat::bindings::resized;

extern "C" {

EMSCRIPTEN_KEEPALIVE BakeJob* abflatNewJob() { return abflat::bindings::newJob<BakeJob>(); }

EMSCRIPTEN_KEEPALIVE void abflatFreeJob(BakeJob* job) { delete job; }

// Buffers for the arrays of a job, `size` numbers.

EMSCRIPTEN_KEEPALIVE double* abflatPositions(BakeJob* job, std::size_t size) {
  return resized(job->positions, size);
}
EMSCRIPTEN_KEEPALIVE double* abflatTexcoords(BakeJob* job, std::size_t size) {
  return resized(job->texcoords, size);
}
EMSCRIPTEN_KEEPALIVE float* abflatColours(BakeJob* job, std::size_t size) {
  return resized(job->colours, size);
}
EMSCRIPTEN_KEEPALIVE float* abflatNormals(BakeJob* job, std::size_t size) {
  return resized(job->normals, size);
}
EMSCRIPTEN_KEEPALIVE float* abflatTangents(BakeJob* job, std::size_t size) {
  return resized(job->tangents, size);
}
EMSCRIPTEN_KEEPALIVE std::uint32_t* abflatIndices(BakeJob* job, std::size_t size) {
  return resized(job->indices, size);
}
EMSCRIPTEN_KEEPALIVE std::uint32_t* abflatMaterials(BakeJob* job, std::size_t size) {
  return resized(job->faceMaterials, size);
}
EMSCRIPTEN_KEEPALIVE std::uint32_t* abflatParts(BakeJob* job, std::size_t size) {
  return resized(job->parts, size);
}
EMSCRIPTEN_KEEPALIVE double* abflatUv(BakeJob* job, std::size_t size) {
  return resized(job->uv, size);
}
EMSCRIPTEN_KEEPALIVE std::uint32_t* abflatLayoutIndices(BakeJob* job, std::size_t size) {
  return resized(job->layoutIndices, size);
}
EMSCRIPTEN_KEEPALIVE std::uint32_t* abflatVertexMap(BakeJob* job, std::size_t size) {
  return resized(job->vertexMap, size);
}

/// Buffer for the pixels of one more image, `size` bytes.
EMSCRIPTEN_KEEPALIVE std::uint8_t* abflatImage(BakeJob* job, std::size_t size) {
  return resized(job->images.emplace_back(), size);
}

/// Adds a use of an image; wraps are numbered as abflat::Wrap is.
EMSCRIPTEN_KEEPALIVE void abflatTexture(BakeJob* job, std::size_t image, std::uint32_t width,
                                        std::uint32_t height, int wrapU, int wrapV,
                                        bool alphaIsOpacity) {
  abflat::BakeTexture& texture = job->textures.emplace_back();
  texture.image = {job->images[image].data(), width, height};
  texture.wrapU = static_cast<abflat::Wrap>(wrapU);
  texture.wrapV = static_cast<abflat::Wrap>(wrapV);
  texture.space =
      job->kind == ImageKind::Colour ? abflat::ColourSpace::Srgb : abflat::ColourSpace::Linear;
  texture.alphaIsOpacity = alphaIsOpacity;
}

/// Adds a source; `texture` is abflat::kNoTexture if it has no image.
EMSCRIPTEN_KEEPALIVE void abflatSource(BakeJob* job, std::uint32_t texture, double offsetU,
                                       double offsetV, double rotation, double scaleU,
                                       double scaleV, double red, double green, double blue,
                                       double alpha) {
  job->materials.push_back(
      {texture, {offsetU, offsetV}, rotation, {scaleU, scaleV}, {red, green, blue, alpha}});
}

/// Sets what is not an array; to be called before textures are added.
EMSCRIPTEN_KEEPALIVE void abflatSettings(BakeJob* job, int kind, double resolution,
                                         double layoutResolution, int padding, bool isOpaque) {
  job->kind = static_cast<ImageKind>(kind);
  job->resolution = abflat::atlasSize(resolution, true);
  job->layoutResolution = abflat::atlasSize(layoutResolution, true);
  job->padding = padding;
  job->isOpaque = isOpaque;
}

EMSCRIPTEN_KEEPALIVE int abflatBake(BakeJob* job) {
  const abflat::Status status = bakeJob(*job, abflat::bindings::tellProgress);
  job->text = status.message;
  return static_cast<int>(status.code);
}

EMSCRIPTEN_KEEPALIVE int abflatWidth(const BakeJob* job) { return job->size.width; }
EMSCRIPTEN_KEEPALIVE int abflatHeight(const BakeJob* job) { return job->size.height; }

/// RGBA of 8 bits, rows from the top.
EMSCRIPTEN_KEEPALIVE const std::uint8_t* abflatPixels(const BakeJob* job) {
  return job->pixels.data();
}

EMSCRIPTEN_KEEPALIVE const char* abflatTextData(const BakeJob* job) { return job->text.data(); }

/// Size in bytes.
EMSCRIPTEN_KEEPALIVE std::size_t abflatTextSize(const BakeJob* job) { return job->text.size(); }

}  // extern "C"
