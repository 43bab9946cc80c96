#include "pack/check_packing.h"

#include <cmath>
#include <string>

#include "base/invalid.h"

namespace abflat {

Status checkPackOptions(const PackOptions& o) {
  if (o.resolution.shorter() < 1 || o.resolution.longer() > kMostResolution)
    return invalid("the resolution is " + atlasSizeText(o.resolution) + "; it must be from 1 to " +
                   std::to_string(kMostResolution) + " texels");
  if (o.padding < 0)
    return invalid("the padding is " + std::to_string(o.padding) + "; it must be 0 or more");
  if (o.margin < 0 && o.margin != kAutoMargin)
    return invalid("the margin is " + std::to_string(o.margin) + "; it must be 0 or more");
  const auto noRoom = [&](const std::string& what, int texels) {
    return invalid("a " + what + " of " + std::to_string(texels) +
                   " texels leaves no room in a tile of " + atlasSizeText(o.resolution) +
                   ". Lower the " + what + " or raise the resolution");
  };
  const bool isAuto = o.margin == kAutoMargin;
  const int side = o.resolution.shorter();
  if (o.padding >= side || (isAuto && 2 * marginOf(o) >= side)) return noRoom("padding", o.padding);
  if (2 * marginOf(o) >= side) return noRoom("margin", o.margin);
  if (!(o.texelDensity >= 0) || !std::isfinite(o.texelDensity))
    return invalid("the texel density must be a finite number, 0 or above");
  return {};
}

Status checkPackShapes(const std::vector<PackShape>& shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (const double x : shapes[i].uv)
      if (!std::isfinite(x))
        return {StatusCode::InvalidMesh, "chart " + std::to_string(i) +
                                             " has a coordinate that is not finite. Flatten the "
                                             "charts before packing them"};
  return {};
}

}  // namespace abflat
