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
  Text = 4,  ///< JSON of a result, or the message of an error
  ChartOfTriangle = 5,  ///< chart of each triangle
  Seams = 6,  ///< edges that were cut, two input vertices each
  Unpacked = 7,  ///< uv before packing
  Faces = 8,  ///< input face of each triangle of a loaded file
  Faults = 9,  ///< what is wrong with each triangle in uv: a sum of the bits of UvFault
  IslandOfFace = 10,  ///< uv island of each input face
};

/// The file of the first MeshFormat, as a Field; those of the others follow.
constexpr int kFirstFile = 11;

}  // namespace abflat::bindings
