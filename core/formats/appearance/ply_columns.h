#pragma once

#include <string_view>
#include <vector>

#include "io/ply_header.h"

namespace abflat {

/// Numbers of the vertices of a PLY file that has been read: the values of `properties`, none of
/// which is a list, row after row. Anything that is not a number becomes NaN.
std::vector<double> plyColumns(const PlyHeader& header, std::string_view bytes,
                               const std::vector<std::size_t>& properties);

}  // namespace abflat
