#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace abflat {

/// Stands for "no value" in CornerAttribute::row.
constexpr std::uint32_t kNoRow = 0xffffffffu;

/// What a file says about the corners of faces: normals, colours, materials, and so on.
struct CornerAttribute {
  std::string name;                ///< as in "1 face has other normals"
  std::size_t width = 1;           ///< numbers per row
  std::vector<double> values;      ///< row by row
  std::vector<std::uint32_t> row;  ///< per face corner, or kNoRow
  double tolerance = 0;            ///< by how much numbers may differ and still be the same
};

}  // namespace abflat
