#pragma once

#include <string>
#include <vector>

#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat::cli {

/// Which faces keep their texcoords.
struct KeptFaces {
  bool hasUv = false;  ///< all that have some
  std::string file;    ///< with a number a line, counted from 0; empty: none

  bool any() const { return hasUv || !file.empty(); }
};

/// The list of --keep: "uv", "file=PATH", or both with a comma between. Errors:
/// InvalidOption.
Result<KeptFaces> parseKept(const std::string& text);

/// Their numbers, ascending. Errors: those of readRows; InvalidOption when there are no
/// texcoords to keep.
Result<std::vector<std::uint32_t>> facesToKeep(const KeptFaces& kept, const PolygonMesh& mesh,
                                               const std::string& name);

}  // namespace abflat::cli
