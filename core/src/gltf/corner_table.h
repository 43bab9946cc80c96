#pragma once

#include <cstdint>
#include <vector>

namespace abflat::gltf {

/// In place of a number of a texcoord or normal.
constexpr std::uint32_t kNoNumber = 0xffffffff;

/// What a corner of a face refers to.
struct Corner {
  std::uint32_t vertex = 0;
  std::uint32_t texcoord = kNoNumber, oldTexcoord = kNoNumber, normal = kNoNumber;

  bool operator==(const Corner& o) const {
    return vertex == o.vertex && texcoord == o.texcoord && oldTexcoord == o.oldTexcoord &&
           normal == o.normal;
  }
};

/// Vertices of the primitives, each once for all that a corner refers to.
class CornerTable {
 public:
  struct PrimitiveVertices {
    std::vector<Corner> corners;  ///< by vertex of the primitive
    std::vector<std::uint32_t> indices;
  };

  CornerTable(std::size_t vertices, std::size_t primitives)
      : newest_(vertices, kNoNumber), primitives_(primitives) {}

  void add(const Corner& corner, std::uint32_t primitive);

  const std::vector<PrimitiveVertices>& primitives() const { return primitives_; }

 private:
  struct Entry {
    Corner corner;
    std::uint32_t primitive, number, older;  ///< older: entry of the same vertex of the mesh
  };

  std::vector<std::uint32_t> newest_;  ///< entry by vertex of the mesh
  std::vector<Entry> entries_;
  std::vector<PrimitiveVertices> primitives_;
};

}  // namespace abflat::gltf
