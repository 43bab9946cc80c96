#pragma once

#include <string_view>

#include "abflat/io.h"

namespace abflat {

/// STL, text or binary. The format has no connectivity: corners at identical coordinates become one
/// vertex, so that a closed STL is a closed mesh. Every facet becomes a face, in order, even one
/// without area, which may then use a vertex twice. Several solids become one mesh.
Result<PolygonMesh> readStl(std::string_view bytes, std::string_view fileName);

/// Whether the bytes are certainly STL: a text that begins like one, or a file of exactly the size
/// that a binary header announces.
bool looksLikeStl(std::string_view bytes);

}  // namespace abflat
