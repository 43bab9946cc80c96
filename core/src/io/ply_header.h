#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "abflat/status.h"

namespace abflat {

enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

constexpr std::size_t sizeOf(PlyType type) {
  constexpr std::uint8_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}
/// The name that every reader knows: "uchar", not "uint8".
std::string_view nameOf(PlyType type);

enum class PlyEncoding { Text, LittleEndian, BigEndian };

constexpr std::size_t kNoIndex = static_cast<std::size_t>(-1);

struct PlyProperty {
  std::string_view name;
  PlyType type = PlyType::Float32;       ///< of the number, or of each number of the list
  PlyType countType = PlyType::Float32;  ///< of the number that a list begins with
  bool isList = false;
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  bool hasLists = false;
  std::size_t leastBytes = 0;  ///< of a row of a binary file; the exact size if there are no lists

  /// kNoIndex if there is none.
  std::size_t find(std::string_view property) const;
};

/// The contents of a PLY header. Views refer to the bytes of the file.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Text;
  std::vector<PlyElement> elements;
  std::string_view text;     ///< including the line that ends it
  std::string_view lineEnd;  ///< of its first line, and hence of the others
  std::size_t lines = 0;

  std::size_t vertex = kNoIndex;    ///< element
  std::size_t face = kNoIndex;      ///< element; kNoIndex in a point cloud
  bool hasStrips = false;           ///< `face` is made of triangle strips, which -1 ends
  std::size_t x = 0, y = 0, z = 0;  ///< properties of a vertex
  std::array<std::size_t, 3> normal = {kNoIndex, kNoIndex, kNoIndex};  ///< nx, ny, nz; all or none
  std::size_t corners = kNoIndex;  ///< property of a face or strip: the list of its vertices

  // Properties that hold texcoords; kNoIndex if there are none.
  std::size_t u = kNoIndex, v = kNoIndex;  ///< of a vertex; unused if corners have texcoords
  std::size_t cornerTexcoords = kNoIndex;  ///< of a face: u and v of each corner in turn
};

/// The names that programs use for the texcoords of a vertex.
constexpr std::string_view kPlyTexcoordNames[][2] = {
    {"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};

/// As MeshLab writes them.
inline bool isCornerTexcoords(const PlyProperty& property) {
  return property.isList && (property.name == "texcoord" || property.name == "texcoords");
}

/// Errors: ParseError (names file and line), also if there are no vertices with x, y and z, faces
/// or strips have no lists of vertices, or there are both.
Result<PlyHeader> readPlyHeader(std::string_view bytes, std::string_view fileName);

/// The first line of the rest of a header, including its end. If lines end in "\r" alone, as on old
/// Macs, a "\n" after the last one is data.
std::string_view headerLine(std::string_view rest, std::string_view lineEnd);

}  // namespace abflat
