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
#include "abflat/unwrap.h"
#include "generated/field.h"

namespace abflat::bindings {

/// What a layout is for JavaScript, of either kind; what a kind does not have is empty.
struct LayoutArrays {
  std::vector<double> uv;                ///< 2 per output vertex
  std::vector<std::uint32_t> triangles;  ///< 3 output vertices per triangle
  std::vector<std::uint32_t> vertexMap;  ///< input vertex of each output vertex
  std::vector<double> positions;         ///< 3 per output vertex, files only
  std::vector<std::uint32_t> chartOfTriangle;
  std::vector<EdgeVertices> seams;
  std::vector<double> unpacked;      ///< 2 per output vertex
  std::vector<std::uint32_t> faces;  ///< input face per triangle, of a loaded file
};

/// One call from JavaScript: the input it wrote, then the results it reads.
struct Job {
  std::string name;    ///< of the input, in messages and reports
  std::string source;  ///< bytes of a file; unused when the mesh came as arrays
  bool isFile = false;
  MeshFormat format = MeshFormat::Obj;  ///< of the file
  PolygonMesh mesh;
  FlattenOptions options;
  UnwrapOptions unwrapOptions;
  std::string seams = "auto";  ///< as parseSeams takes them; unwrapOptions has the edges
  bool keepsUv = false;        ///< all faces with texcoords are fixed; unwrapOptions has others
  bool normalizes = false;     ///< a flattened mesh is moved and scaled into the unit square
  LayoutArrays layout;
  std::vector<MethodResult> methods;  ///< of a comparison
  std::string obj, ply;               ///< files, when asked for
  std::string text;                   ///< JSON on success, otherwise the message of the error
};

struct Bytes {
  const void* data = nullptr;
  std::size_t size = 0;
};

Bytes resultOf(const Job& job, Field field);

/// The layout by one method of a comparison, in the order of its JSON; empty where there is none.
Bytes methodUvOf(const Job& job, std::size_t method);

/// Room for one of the arrays of a known layout, which are Uv, Unpacked, Indices, VertexMap and
/// ChartOfTriangle.
void* knownRoom(Job& job, Field field, std::size_t size);

/// Parses the file, or checks the arrays. Errors: those of detectFormat, readMesh, validateArrays.
Status readInput(Job& job);

/// Files to write beside the arrays of a layout.
struct WantedFiles {
  bool obj = false, ply = false;
};

/// Fills everything that resultOf() returns of a layout, normalized and rounded as the job says.
/// `progress` as in FlattenOptions, with the stages Read and Write added.
Status flattenJob(Job& job, WantedFiles wanted, const ProgressCallback& progress);

/// The same, `progress` as in UnwrapOptions. Texcoords are rounded to single precision, which is
/// what graphics cards and PLY hold, unless OBJ alone is wanted, which is written as it is by the
/// program, or to what a glTF holds where the options say so.
Status unwrapJob(Job& job, WantedFiles wanted, const ProgressCallback& progress);

/// Fills what resultOf() returns but uv, and job.methods. `progress` as in CompareOptions, with the
/// stage Read added.
Status compareJob(Job& job, const ProgressCallback& progress);

Status inspectJob(Job& job);

/// The triangles of the input, whatever its topology.
Status loadJob(Job& job);

/// Makes the sample called job.name. Errors: InvalidOption, with the names there are.
Status sampleJob(Job& job, double detail);

}  // namespace abflat::bindings
