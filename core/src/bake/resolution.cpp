#include <algorithm>
#include <cmath>
#include <vector>

#include "abflat/bake.h"

namespace abflat {
namespace {

double uvArea(const std::vector<double>& uv, std::size_t t) {
  const double* const p = &uv[6 * t];
  return std::abs((p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0])) / 2;
}

constexpr int kLeastSide = 16, kUsualSide = 1024, kMostSide = 8192;

/// With that longer side.
AtlasSize inShape(const AtlasSize& shape, double longer) {
  const double most = std::clamp<double>(longer, kLeastSide, kMostSide);
  const auto side = [&](int own) {
    const double texels = std::round(most * own / shape.longer());
    return static_cast<int>(std::clamp<double>(texels, kLeastSide, kMostSide));
  };
  return {side(shape.width), side(shape.height)};
}

}  // namespace

double bakeResolution(const BakeInput& input) {
  struct Share {
    double side, area;
  };
  std::vector<Share> shares;
  double sum = 0;
  const BakeTriangles& triangles = input.triangles;
  for (std::size_t t = 0; t < triangles.count(); ++t) {
    const BakeMaterial& material = input.materials[triangles.materials[t]];
    if (material.texture == kNoTexture) continue;
    const ImageView& image = input.textures[material.texture].image;
    const double area = uvArea(triangles.uv, t);
    const double texels = uvArea(triangles.oldUv, t) *
                          std::abs(material.scale[0] * material.scale[1]) * image.width *
                          image.height;
    if (!(area > 0) || !(texels > 0)) continue;
    shares.push_back({std::sqrt(texels / area), area});
    sum += area;
  }
  std::sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) {
    return a.side != b.side ? a.side < b.side : a.area < b.area;
  });
  double below = 0;
  for (const Share& share : shares) {
    below += share.area;
    if (2 * below >= sum) return share.side;
  }
  return 0;
}

AtlasSize bakeSize(const BakeInput& input, const AtlasSize& wanted, const AtlasSize& layout) {
  const AtlasSize shape = layout == 0 ? AtlasSize(1) : layout;
  if (wanted != 0) return wanted.isSquare() ? inShape(shape, wanted.width) : wanted;
  const double side = bakeResolution(input) * (shape.longer() / shape.meanSide());
  if (!(side > 0)) return inShape(shape, layout == 0 ? kUsualSide : layout.longer());
  return inShape(shape, std::exp2(std::round(std::log2(side))));
}

std::uint32_t bakePadding(int padding, const AtlasSize& image, const AtlasSize& layout) {
  if (layout == 0) return static_cast<std::uint32_t>(padding);
  const double scale = std::max(static_cast<double>(image.width) / layout.width,
                                static_cast<double>(image.height) / layout.height);
  return static_cast<std::uint32_t>(std::ceil(padding * scale));
}

}  // namespace abflat
