#pragma once

#include <cstdint>
#include <vector>

#include "gltf/source.h"

namespace abflat::gltf {

/// Vertices of a group that have one texcoord each: its own in their order, copies behind them.
struct SplitGroup {
  std::vector<std::uint32_t> copied;  ///< vertex of the group that each copy repeats
  std::vector<float> uv;              ///< 2 per vertex, v downwards
};

struct SplitPart {
  std::vector<std::uint32_t> triangles;  ///< 3 vertices of the group each
  bool needsIndices = false;             ///< those that it has are no longer right
};

struct SplitParts {
  std::vector<SplitGroup> groups;
  std::vector<SplitPart> parts;
};

/// Arguments as for writeGltf.
SplitParts splitParts(const Source& source, const std::vector<double>& uv,
                      const std::vector<std::uint32_t>& cornerUv);

}  // namespace abflat::gltf
