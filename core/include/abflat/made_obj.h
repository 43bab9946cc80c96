#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "abflat/export.h"
#include "abflat/mesh.h"

// A new OBJ and its material file, made from a mesh of another format.

namespace abflat {

/// In glTF's terms: colours are linear. A map is the name of a file; empty for none.
struct MadeMaterial {
  std::string name;
  std::array<double, 3> colour = {1, 1, 1}, emission = {0, 0, 0};
  double opacity = 1, metallic = 0, roughness = 1;
  std::string colourMap, opacityMap, metallicMap, roughnessMap, normalMap, emissionMap;
};

/// Materials under the names that programs read back: without blanks, and each of its own.
ABFLAT_API void settleNames(std::vector<MadeMaterial>& materials);

/// The material file.
ABFLAT_API std::string makeMtl(const std::vector<MadeMaterial>& materials);

/// The OBJ with normals, naming the material file `library`. Arguments as for writeObj; `materials`
/// are those of faceMaterials, or one for all faces.
ABFLAT_API std::string makeObj(const PolygonMesh& mesh, const std::vector<double>& uv,
                               const std::vector<std::uint32_t>& cornerUv,
                               const std::string& library,
                               const std::vector<MadeMaterial>& materials);

}  // namespace abflat
