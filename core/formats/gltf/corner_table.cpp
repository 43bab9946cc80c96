#include "gltf/corner_table.h"

#include <tuple>

#include "io/first_alike.h"

namespace abflat::gltf {
namespace {

auto keyOf(const Corner& c) { return std::tie(c.primitive, c.texcoord, c.oldTexcoord, c.normal); }

}  // namespace

std::vector<PrimitiveVertices> verticesOf(const std::vector<Corner>& corners,
                                          std::size_t meshVertices, std::size_t primitives) {
  std::vector<std::uint32_t> vertex;
  vertex.reserve(corners.size());
  for (const Corner& corner : corners) vertex.push_back(corner.vertex);
  const std::vector<std::uint32_t> first = firstAlike(
      meshVertices, vertex,
      [&](std::uint32_t a, std::uint32_t b) { return keyOf(corners[a]) < keyOf(corners[b]); });
  std::vector<PrimitiveVertices> out(primitives);
  std::vector<std::uint32_t>& number = vertex;  // from here on: number in its primitive
  for (std::size_t c = 0; c < corners.size(); ++c) {
    PrimitiveVertices& own = out[corners[c].primitive];
    if (first[c] == c) {
      number[c] = static_cast<std::uint32_t>(own.corners.size());
      own.corners.push_back(corners[c]);
    }
    own.indices.push_back(number[first[c]]);
  }
  return out;
}

}  // namespace abflat::gltf
