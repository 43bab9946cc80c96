#pragma once

#include <cstdint>
#include <vector>

#include "gltf/document.h"

namespace abflat::gltf {

/// Vertices of the mesh that come from the same accessors, in order. Primitives that share all
/// accessors share their vertices.
struct VertexGroup {
  std::size_t mesh = 0, primitive = 0;  ///< one that has these accessors
  std::uint32_t firstVertex = 0, vertexCount = 0;
};

/// Triangles of the mesh that come from one primitive, in order.
struct Part {
  std::size_t mesh = 0, primitive = 0, group = 0;
  std::uint32_t firstFace = 0, faceCount = 0;
  bool isMirrored = false;  ///< corners 1 and 2 are swapped, so that outside remains outside
};

struct Source {
  Document document;
  std::vector<VertexGroup> groups;
  std::vector<Part> parts;
  std::uint32_t vertexCount = 0;
  std::vector<std::uint32_t> faceVertices;  ///< of the mesh as it was read
};

}  // namespace abflat::gltf
