#pragma once

#include <string_view>

#include "abflat/appearance.h"

namespace abflat {

// Each fills in what its format has. Colours are sRGB and normals have any length; corners without
// a normal have kNoNormal, an index that does not exist, or a normal that is not finite.

constexpr std::uint32_t kNoNormal = 0xffffffffu;

void readObjAppearance(std::string_view bytes, const PolygonMesh& mesh,
                       const ReadResource& readResource, Appearance& out);
void readPlyAppearance(std::string_view bytes, const PolygonMesh& mesh,
                       const ReadResource& readResource, Appearance& out);

}  // namespace abflat
