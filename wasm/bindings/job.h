#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "abflat/compare.h"
#include "abflat/flatten.h"
#include "abflat/io.h"
#include "abflat/mesh.h"
#include "abflat/pack_layout.h"
#include "abflat/status.h"
#include "abflat/unwrap.h"
#include "generated/field.h"

namespace abflat::bindings {

/// A layout of any kind, in the form JavaScript gets. Arrays that a kind does not have are
/// empty.
struct LayoutArrays {
  std::vector<double> uv;                ///< 2 per output vertex
  std::vector<std::uint32_t> triangles;  ///< 3 output vertices per triangle
  std::vector<std::uint32_t> vertexMap;  ///< input vertex of each output vertex
  std::vector<double> positions;         ///< 3 per output vertex, files only
  std::vector<std::uint32_t> chartOfTriangle;
  std::vector<EdgeVertices> seams;
  std::vector<double> unpacked;      ///< 2 per output vertex
  std::vector<std::uint32_t> faces;  ///< input face per triangle, of a loaded file
  std::vector<std::uint8_t> faults;  ///< per triangle, of a layout that was packed
};

/// One call from JavaScript: the input that it wrote, then the results that it reads.
struct Job {
  std::string name;    ///< of the input, in messages and reports
  std::string source;  ///< bytes of a file; unused if the mesh came as arrays
  bool isFile = false;
  MeshFormat format = MeshFormat::Obj;  ///< of the file
  PolygonMesh mesh;
  bool hasCornerNormals = false;  ///< normals of the arrays are those of corners, not of vertices
  FlattenOptions options;
  UnwrapOptions unwrapOptions;
  PackLayoutOptions packOptions;
  std::string seams = "auto";  ///< as for parseSeams; edges are in unwrapOptions
  bool keepsUv = false;     ///< all faces with texcoords are fixed, besides those in unwrapOptions
  bool normalizes = false;  ///< a flattened mesh is moved and scaled into the unit square
  LayoutArrays layout;
  std::vector<MethodResult> methods;       ///< of a comparison
  std::string files[kWrittenFormatCount];  ///< by format, if asked for
  std::string text;                        ///< JSON on success, otherwise the error message
};

struct Bytes {
  const void* data = nullptr;
  std::size_t size = 0;
};

Bytes resultOf(const Job& job, Field field);

/// The layout by one method of a comparison, in the order of its JSON; empty if there is none.
Bytes methodUvOf(const Job& job, std::size_t method);

/// Buffer for one of the arrays of a known layout: Uv, Unpacked, Indices, VertexMap or
/// ChartOfTriangle.
void* knownRoom(Job& job, Field field, std::size_t size);

/// Parses the file, or checks the arrays. Errors: those of detectFormat, readMesh, validateArrays.
Status readInput(Job& job);

/// Files to write besides the arrays of a layout: a bit for each MeshFormat.
using WantedFiles = unsigned;

/// Fills everything that resultOf() returns for a layout, normalized and rounded as the job says.
/// `progress` as in FlattenOptions, plus the stages Read and Write.
Status flattenJob(Job& job, WantedFiles wanted, const ProgressCallback& progress);

/// The same for unwrapping; `progress` as in UnwrapOptions. Texcoords are rounded to what a glTF
/// holds if the options say so. Otherwise they are rounded to single precision, which is what
/// graphics cards and PLY hold, unless only files of double precision are wanted, which are then
/// written exactly as the program writes them.
Status unwrapJob(Job& job, WantedFiles wanted, const ProgressCallback& progress);

/// The same for packing the layout that the mesh has, rounded in the same way. What is known of the
/// charts is that of the islands.
Status packJob(Job& job, WantedFiles wanted, const ProgressCallback& progress);

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
