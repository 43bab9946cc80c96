#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace abflat {

// Nearly all lines of an OBJ file are plain: just numbers and single separators, which need no
// closer look. These functions parse such a line in a single pass. For any other line, valid or
// not, they return 0 and leave it to ObjLines to interpret.

/// If `text` begins with a line that has no comment and that no backslash joins with the next,
/// returns its size including the line end.
std::size_t plainLine(std::string_view text);

/// If `text` begins with a line "v x y z", possibly followed by colours, sets the point and returns
/// the size of the line including its end.
std::size_t plainVertexLine(std::string_view text, std::array<double, 3>& point);

/// If `text` begins with a line "vt u v", possibly followed by a third number, sets the texcoord
/// and returns the size of the line including its end.
std::size_t plainTexcoordLine(std::string_view text, std::array<double, 2>& texcoord);

/// The same for a line "vn x y z".
std::size_t plainNormalLine(std::string_view text, std::array<double, 3>& normal);

/// A corner of a face, with indices as written: counted from 1, or backwards from the end.
struct ObjCorner {
  std::int64_t vertex = 0;    ///< never 0
  std::int64_t texcoord = 0;  ///< 0: none
  std::int64_t normal = 0;    ///< 0: none
};

/// If `text` begins with a line "f ..." of 3 or more corners, appends them and returns the size of
/// the line including its end.
std::size_t plainFaceLine(std::string_view text, std::vector<ObjCorner>& corners);

}  // namespace abflat
