#pragma once

#include <cstdint>
#include <vector>

namespace abflat::gltf {

/// In place of the index of a texcoord or normal.
constexpr std::uint32_t kNoNumber = 0xffffffff;

/// What a corner of a triangle refers to, and the primitive that its triangle belongs to.
struct Corner {
  std::uint32_t vertex = 0, primitive = 0;
  std::uint32_t texcoord = kNoNumber, oldTexcoord = kNoNumber, normal = kNoNumber;
};

struct PrimitiveVertices {
  std::vector<Corner> corners;  ///< by vertex of the primitive
  std::vector<std::uint32_t> indices;
};

/// Vertices of the primitives: one for each distinct combination that corners refer to, in the
/// order of the corners.
std::vector<PrimitiveVertices> verticesOf(const std::vector<Corner>& corners,
                                          std::size_t meshVertices, std::size_t primitives);

}  // namespace abflat::gltf
