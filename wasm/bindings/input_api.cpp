// The functions of every module that is given a mesh. Sizes are in elements unless said otherwise;
// pointers are valid until the job is freed or the next call that takes it.

#include <emscripten/emscripten.h>

#include <utility>

#include "input_job.h"

using abflat::bindings::Field;
using abflat::bindings::InputJob;

extern "C" {

/// Buffer for the name of the input (UTF-8), `size` bytes.
EMSCRIPTEN_KEEPALIVE char* abflatName(InputJob* job, std::size_t size) {
  job->name.resize(size);
  return job->name.data();
}

/// Buffer for the content of a file, `size` bytes.
EMSCRIPTEN_KEEPALIVE char* abflatSource(InputJob* job, std::size_t size) {
  job->isFile = true;
  job->source.resize(size);
  return job->source.data();
}

/// Buffer for the positions of a mesh given as arrays, `size` coordinates.
EMSCRIPTEN_KEEPALIVE double* abflatPositions(InputJob* job, std::size_t size) {
  job->mesh.positions.resize(size);
  return job->mesh.positions.data();
}

/// Buffer for the triangles of a mesh given as arrays, `size` vertex numbers.
EMSCRIPTEN_KEEPALIVE std::uint32_t* abflatIndices(InputJob* job, std::size_t size) {
  job->mesh =
      abflat::makeTriangleMesh(std::move(job->mesh.positions), std::vector<std::uint32_t>(size));
  return job->mesh.faceVertices.data();
}

/// Buffer for the texcoords of a mesh given as arrays, two per vertex. To be called after its
/// triangles.
EMSCRIPTEN_KEEPALIVE double* abflatTexcoords(InputJob* job, std::size_t size) {
  job->mesh.texcoords.resize(size);
  return job->mesh.texcoords.data();
}

/// Buffer for the normals of a mesh given as arrays, three per vertex or per corner of a triangle.
/// To be called after its triangles.
EMSCRIPTEN_KEEPALIVE double* abflatNormals(InputJob* job, std::size_t size, bool areOfCorners) {
  job->mesh.normals.resize(size);
  job->hasCornerNormals = areOfCorners;
  return job->mesh.normals.data();
}

/// Buffer for the materials of a mesh given as arrays, one per triangle. To be called after its
/// triangles.
EMSCRIPTEN_KEEPALIVE std::uint32_t* abflatMaterials(InputJob* job, std::size_t size) {
  job->mesh.faceMaterials.resize(size);
  return job->mesh.faceMaterials.data();
}

/// Buffer for the objects of a mesh given as arrays, one number per vertex. To be called after its
/// triangles.
EMSCRIPTEN_KEEPALIVE std::uint32_t* abflatVertexObjects(InputJob* job, std::size_t size) {
  job->mesh.vertexObjects.resize(size);
  return job->mesh.vertexObjects.data();
}

EMSCRIPTEN_KEEPALIVE const void* abflatResultData(const InputJob* job, int field) {
  return resultOf(*job, static_cast<Field>(field)).data;
}

/// Size in bytes.
EMSCRIPTEN_KEEPALIVE std::size_t abflatResultSize(const InputJob* job, int field) {
  return resultOf(*job, static_cast<Field>(field)).size;
}

}  // extern "C"
