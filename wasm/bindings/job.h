#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "abflat/compare.h"
#include "abflat/flatten.h"
#include "abflat/io.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat::bindings {

/// One call from JavaScript: the input it wrote, then the results it reads.
struct Job {
  std::string name;    ///< of the input, in messages and reports
  std::string source;  ///< bytes of a file; unused when the mesh came as arrays
  bool isFile = false;
  MeshFormat format = MeshFormat::Obj;  ///< of the file
  PolygonMesh mesh;
  FlattenOptions options;
  FlattenResult result;
  std::vector<MethodResult> methods;  ///< of a comparison
  std::vector<double> positions;      ///< 3 per output vertex, files only
  std::string obj, ply;               ///< files, when asked for
  std::string text;                   ///< JSON on success, otherwise the message of the error
};

/// What JavaScript can read from a finished job; the numbers are those of `Field` in engine.ts.
enum class Field : int { Uv, Indices, VertexMap, Positions, Obj, Ply, Text };

struct Bytes {
  const void* data = nullptr;
  std::size_t size = 0;
};

Bytes resultOf(const Job& job, Field field);

/// The layout by one method of a comparison, in the order of its JSON; empty where there is none.
Bytes methodUvOf(const Job& job, std::size_t method);

/// Parses the file, or checks the arrays. Errors: those of detectFormat, readMesh, validateArrays.
Status readInput(Job& job);

/// Files to write beside the arrays of a layout.
struct WantedFiles {
  bool obj = false, ply = false;
};

/// Fills everything that resultOf() returns. `progress` as in FlattenOptions, with the stages
/// "read" and "write" added.
Status flattenJob(Job& job, WantedFiles wanted, const ProgressCallback& progress);

/// Fills what resultOf() returns but uv, and job.methods. `progress` as in CompareOptions, with the
/// stage "read" added.
Status compareJob(Job& job, const ProgressCallback& progress);

Status inspectJob(Job& job);

/// The triangles of the input, whatever its topology.
Status loadJob(Job& job);

/// Makes the sample called job.name. Errors: InvalidOption, with the names there are.
Status sampleJob(Job& job, double detail);

}  // namespace abflat::bindings
