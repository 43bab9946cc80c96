#pragma once

#include <string>
#include <vector>

#include "abflat/gltf.h"

namespace abflat::test {

/// The bytes of values as stored in a file.
template <class T>
std::string bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// A .glb with this JSON and buffer. `{SIZE}` in the JSON stands for the size of the buffer.
std::string glbOf(std::string json, const std::string& buffer);

/// A closed surface (an octahedron) with 8-bit indices, a colour for each vertex and a sparse morph
/// target. `meshes`: so many with the same accessors, all in one place.
std::string octahedronGlb(std::size_t meshes = 1);

/// Reads a file that refers to no other files.
Result<GltfModel> readAlone(const std::string& bytes);

}  // namespace abflat::test
