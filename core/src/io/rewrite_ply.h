#pragma once

#include <string_view>
#include <vector>

#include "io/ply_plan.h"

namespace abflat {

/// A PLY file that has been read, and what to write in place of its texcoords.
struct PlyRewrite {
  const PlyHeader& header;
  const PlyPlan& plan;
  const PolygonMesh& mesh;
  const SplitVertices& vertices;
};

/// Writes everything after the header; `body` is that of the source.
void rewritePlyText(TextWriter& out, const PlyRewrite& rewrite, std::string_view body);
void rewritePlyBinary(TextWriter& out, const PlyRewrite& rewrite, std::string_view body);

}  // namespace abflat
