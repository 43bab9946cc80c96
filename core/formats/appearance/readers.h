#pragma once

#include <string_view>

#include "abflat/appearance.h"

namespace abflat {

// Each fills what its format has. Colours are sRGB, normals of any length: corners without one have
// kNoNormal, a normal that does not exist, or one that is not finite.

constexpr std::uint32_t kNoNormal = 0xffffffffu;

void readObjAppearance(std::string_view bytes, const PolygonMesh& mesh,
                       const ReadResource& readResource, Appearance& out);
void readPlyAppearance(std::string_view bytes, const PolygonMesh& mesh,
                       const ReadResource& readResource, Appearance& out);

}  // namespace abflat
