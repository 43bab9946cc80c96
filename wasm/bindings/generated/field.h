// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

namespace abflat::bindings {

/// What JavaScript can read from a finished job.
enum class Field : int {
  Uv = 0,  ///< 2 per output vertex
  Indices = 1,  ///< 3 output vertices per triangle
  VertexMap = 2,  ///< input vertex of each output vertex
  Positions = 3,  ///< 3 per output vertex, for file input only
  Obj = 4,  ///< OBJ text, if asked for
  Ply = 5,  ///< PLY file, if asked for
  Text = 6,  ///< JSON of a result, or the message of an error
  ChartOfTriangle = 7,  ///< chart of each triangle
  Seams = 8,  ///< edges that were cut, two input vertices each
  Unpacked = 9,  ///< uv before packing
  Faces = 10,  ///< input face of each triangle of a loaded file
};

}  // namespace abflat::bindings
