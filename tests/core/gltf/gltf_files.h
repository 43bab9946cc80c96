#pragma once

#include <string>
#include <vector>

#include "abflat/gltf.h"

namespace abflat::test {

/// The bytes of values as a file has them.
template <class T>
std::string bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// A .glb of this JSON and buffer. `{SIZE}` in the JSON stands for the size of the buffer.
std::string glbOf(std::string json, const std::string& buffer);

/// A closed surface (an octahedron), indexed in 8 bits, with a colour for each vertex and a morph
/// target that is sparse.
std::string octahedronGlb();

/// Reads a file that refers to no others.
Result<GltfModel> readAlone(const std::string& bytes);

}  // namespace abflat::test
