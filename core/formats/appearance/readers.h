#pragma once

#include <string_view>

#include "abflat/appearance.h"

namespace abflat {

// Each fills in what its format has, besides normals. Colours are sRGB.

void readObjAppearance(std::string_view bytes, const PolygonMesh& mesh,
                       const ReadResource& readResource, Appearance& out);
void readPlyAppearance(std::string_view bytes, const ReadResource& readResource, Appearance& out);

}  // namespace abflat
