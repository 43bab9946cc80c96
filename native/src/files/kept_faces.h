#pragma once

#include <string>
#include <vector>

#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat::cli {

/// Which faces keep their texcoords.
struct KeptFaces {
  bool hasUv = false;                  ///< all that have some
  std::string file;                    ///< with a number a line, counted from 0; empty: none
  std::vector<std::string> materials;  ///< all faces of these

  bool any() const { return hasUv || !file.empty() || !materials.empty(); }
};

/// The list of --keep: "uv", "material=NAME", "file=PATH", or several with commas between. Errors:
/// InvalidOption.
Result<KeptFaces> parseKept(const std::string& text);

/// Their numbers, ascending. Errors: those of readRows; InvalidOption when there are no
/// texcoords to keep, or a material is not in the mesh.
Result<std::vector<std::uint32_t>> facesToKeep(const KeptFaces& kept, const PolygonMesh& mesh,
                                               const std::string& name);

}  // namespace abflat::cli
