#pragma once

#include <string_view>

#include "abflat/io.h"

namespace abflat {

/// STL, text or binary. It has no connectivity: corners at identical coordinates become one vertex,
/// so that a closed STL is a closed mesh. Every facet is a face, in its order, also one without
/// area, which may use a vertex twice then. Several solids are one mesh.
Result<PolygonMesh> readStl(std::string_view bytes, std::string_view fileName);

/// Whether the bytes are certainly STL: a text that begins as one, or of the size that a binary
/// file says.
bool looksLikeStl(std::string_view bytes);

}  // namespace abflat
