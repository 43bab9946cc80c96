#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "abflat/io.h"
#include "abflat/mesh.h"
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
  std::vector<std::uint32_t> faces;  ///< input face per triangle
  std::vector<std::uint8_t> faults;  ///< per triangle, of a layout that was packed or verified
  std::vector<std::uint32_t> islandOfFace;  ///< of a layout that was verified
};

/// What every call about a mesh has: the input that JavaScript wrote, then the results that it
/// reads. The Job of a module derives from it alone, so both have one address.
struct InputJob {
  std::string name;    ///< of the input, in messages and reports
  std::string source;  ///< bytes of a file; unused if the mesh came as arrays
  bool isFile = false;
  MeshFormat format = MeshFormat::Obj;  ///< of the file
  PolygonMesh mesh;
  bool hasCornerNormals = false;  ///< normals of the arrays are those of corners, not of vertices
  LayoutArrays layout;
  std::string files[kWrittenFormatCount];  ///< by format, if asked for
  std::string text;                        ///< JSON on success, otherwise the error message
};

struct Bytes {
  const void* data = nullptr;
  std::size_t size = 0;
};

template <class T>
Bytes bytesOf(const T& container) {
  return {container.data(), container.size() * sizeof(*container.data())};
}

Bytes resultOf(const InputJob& job, Field field);

/// Parses the file, or checks the arrays. Errors: those of detectFormat, readMesh, validateArrays.
Status readInput(InputJob& job);

/// The positions of the file's vertices, in the order of the output vertices.
std::vector<double> outputPositions(const InputJob& job);

/// Stores the message where JavaScript looks for it; returns the code.
int finish(InputJob& job, const Status& status);

/// Picks the given `rows` of `size` numbers each.
std::vector<double> gather(const std::vector<double>& values, std::size_t size,
                           const std::vector<std::uint32_t>& rows);

/// Sets option number `index`.
template <class Options>
int setNumber(InputJob& job, Options& options, int index, double value) {
  if (setOption(options, index, value)) return 0;
  return finish(
      job, {StatusCode::InvalidOption, "option " + std::to_string(index) + " is out of its range"});
}

}  // namespace abflat::bindings
