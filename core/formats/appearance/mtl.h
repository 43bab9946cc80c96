#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

namespace abflat {

/// A material of an OBJ, as far as glTF can express it. Colours are sRGB.
struct MtlMaterial {
  std::array<double, 3> diffuse = {1, 1, 1}, emission = {0, 0, 0};
  double opacity = 1, metallic = 0, roughness = 1;
  bool hasOpacity = false;  ///< given as opacity, not as transparency
  std::string diffuseMap;   ///< path of an image as written; empty: none
};

using MtlMaterials = std::map<std::string, MtlMaterial, std::less<>>;  ///< by name

/// Adds the materials of a file. If two have the same name the first counts; anything that cannot
/// be read is ignored.
void readMtl(std::string_view text, MtlMaterials& out);

}  // namespace abflat
