#pragma once

#include <string>
#include <vector>

#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat::cli {

/// Which faces keep their texcoords.
struct KeptFaces {
  bool hasUv = false;                  ///< all faces that have texcoords
  std::string file;                    ///< with one number per line, counted from 0; empty: none
  std::vector<std::string> materials;  ///< all faces with these materials

  bool any() const { return hasUv || !file.empty() || !materials.empty(); }
};

/// Parses the list of --keep: "uv", "material=NAME", "file=PATH", or several, separated by commas.
/// Errors: InvalidOption.
Result<KeptFaces> parseKept(const std::string& text);

/// The face numbers, ascending. Errors: those of readRows; InvalidOption if there are no texcoords
/// to keep, or if a material is not in the mesh.
Result<std::vector<std::uint32_t>> facesToKeep(const KeptFaces& kept, const PolygonMesh& mesh,
                                               const std::string& name);

}  // namespace abflat::cli
