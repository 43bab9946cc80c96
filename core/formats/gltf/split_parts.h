#pragma once

#include <cstdint>
#include <vector>

#include "gltf/source.h"

namespace abflat::gltf {

/// Vertices of a group with one texcoord each: its own in their order, followed by copies.
struct SplitGroup {
  std::vector<std::uint32_t> copied;  ///< vertex of the group that each copy repeats
  std::vector<float> uv;              ///< 2 per vertex, v pointing down
};

struct SplitPart {
  std::vector<std::uint32_t> triangles;  ///< 3 vertices of the group each
  bool needsIndices = false;             ///< its own indices are no longer right
};

struct SplitParts {
  std::vector<SplitGroup> groups;
  std::vector<SplitPart> parts;
};

/// Arguments as for writeGltf.
SplitParts splitParts(const Source& source, const std::vector<double>& uv,
                      const std::vector<std::uint32_t>& cornerUv,
                      const std::vector<std::uint32_t>& turnedFaces);

}  // namespace abflat::gltf
