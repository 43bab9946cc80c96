#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

namespace abflat {

/// A material of an OBJ as far as a glTF can say it. Colours are sRGB.
struct MtlMaterial {
  std::array<double, 3> diffuse = {1, 1, 1}, emission = {0, 0, 0};
  double opacity = 1, metallic = 0, roughness = 1;
  bool hasOpacity = false;  ///< it is given as such, and not as transparency
  std::string diffuseMap;   ///< path of an image as it is written; empty: none
};

using MtlMaterials = std::map<std::string, MtlMaterial, std::less<>>;  ///< by name

/// Adds the materials of a file. Of two with one name the first counts, and what cannot be read is
/// as if it were not there.
void readMtl(std::string_view text, MtlMaterials& out);

}  // namespace abflat
