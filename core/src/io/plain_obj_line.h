#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace abflat {

// Nearly all lines of an OBJ file are plain: nothing but numbers and single separators that need no
// second look. These functions take such a line off in one sweep. For any other line, right or
// wrong, they return 0, and ObjLines decides what it means.

/// `text` begins with a line without a comment that no backslash joins with the next: its size with
/// its end.
std::size_t plainLine(std::string_view text);

/// `text` begins with a line "v x y z", maybe with colours behind: sets the point and returns the
/// size of the line with its end.
std::size_t plainVertexLine(std::string_view text, std::array<double, 3>& point);

/// `text` begins with a line "vt u v", maybe with a third number behind: sets the texcoord and
/// returns the size of the line with its end.
std::size_t plainTexcoordLine(std::string_view text, std::array<double, 2>& texcoord);

/// A corner of a face by indices as written: counted from 1, or back from the end.
struct ObjCorner {
  std::int64_t vertex = 0;    ///< never 0
  std::int64_t texcoord = 0;  ///< 0: none
};

/// `text` begins with a line "f ..." of 3 or more corners: appends them and returns the size of the
/// line with its end.
std::size_t plainFaceLine(std::string_view text, std::vector<ObjCorner>& corners);

}  // namespace abflat
