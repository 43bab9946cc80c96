#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "abflat/export.h"
#include "abflat/mesh.h"

namespace abflat {

/// Faces to turn so that neighbours run alike, ascending. A part of the surface whose faces run
/// alike already stays as it is. In any other part the winding of most of the area is kept, but
/// closed parts, and parts of which less than three quarters agree, face outwards. Edges that are
/// not between two faces join nothing. `goesOn`, if given, is called now and then; once it returns
/// false, the result is empty.
ABFLAT_API std::vector<std::uint32_t> facesToTurn(const PolygonMesh& mesh,
                                                  const std::function<bool()>& goesOn = {});

/// The order of corners that turns these faces: the first corner of a face stays first, the others
/// are reversed. It leads from the mesh to the one with turned faces, and back.
ABFLAT_API std::vector<std::uint32_t> turnedCorners(const PolygonMesh& mesh,
                                                    const std::vector<std::uint32_t>& faces);

/// Values per corner, in such an order.
template <class T>
std::vector<T> reordered(const std::vector<T>& values, const std::vector<std::uint32_t>& corners) {
  std::vector<T> out;
  out.reserve(values.size());
  for (const std::uint32_t c : corners) out.push_back(values[c]);
  return out;
}

/// Turns faces together with their texcoords.
ABFLAT_API void turnFaces(const std::vector<std::uint32_t>& faces, PolygonMesh& mesh);

}  // namespace abflat
