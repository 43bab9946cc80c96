#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "abflat/mesh.h"
#include "io/ply_header.h"
#include "io/split_vertices.h"
#include "io/text_writer.h"

namespace abflat {

/// What happens to a property of a vertex or a face.
struct PlyTarget {
  enum class Source {
    Copied,
    Dropped,   ///< an old texcoord of a vertex
    Corners,   ///< the vertices of a face
    Texcoords  ///< of the corners of a face
  };
  Source source = Source::Copied;
  PlyType type = PlyType::Float32;
  PlyType countType = PlyType::Float32;  ///< of a list
};

/// How a PLY file is written with new texcoords.
struct PlyPlan {
  std::vector<PlyTarget> vertex, face;  ///< one per property; strips become faces with one alone
  PlyType uvType = PlyType::Float32;  ///< of s and t, which follow the other properties of a vertex
  bool dropsFromVertex = false;
};

/// `float` if it holds all the numbers exactly, otherwise `double`.
PlyType smallestType(const std::vector<double>& numbers);

PlyPlan makePlyPlan(const PlyHeader& header, const PolygonMesh& mesh,
                    const SplitVertices& vertices);

/// Writes the header of the source with the changes of the plan.
void putPlyHeader(TextWriter& out, const PlyHeader& header, const PlyPlan& plan,
                  std::uint64_t vertexCount, std::uint64_t faceCount);

}  // namespace abflat
