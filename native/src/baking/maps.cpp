#include "baking/maps.h"

#include <algorithm>

namespace abflat::cli {
namespace {

using Factor = std::array<double, 4>;

template <class FactorOf>
void addPlan(const std::vector<GltfMaterial>& materials, MapPlan plan, const FactorOf& factorOf,
             std::vector<MapPlan>& out, bool isWanted = false) {
  for (const GltfMaterial& material : materials) plan.factors.push_back(factorOf(material));
  const bool hasTexture = std::any_of(
      materials.begin(), materials.end(),
      [&](const GltfMaterial& material) { return (material.*plan.texture).image != kNoImage; });
  const bool differs = std::any_of(plan.factors.begin(), plan.factors.end(),
                                   [&](const Factor& factor) { return factor != plan.factors[0]; });
  // Without a texture the scale of a normal map means nothing.
  if (isWanted || hasTexture || (differs && plan.kind == MapKind::Colour))
    out.push_back(std::move(plan));
}

}  // namespace

MapPlans planMaps(const std::vector<GltfMaterial>& materials, bool hasVertexColours) {
  MapPlans out;
  bool hasAlpha = false;
  for (const GltfMaterial& material : materials) {
    hasAlpha = hasAlpha || material.alpha != GltfAlpha::Opaque;
    for (const double value : material.emission)
      out.emissiveStrength = std::max(out.emissiveStrength, value);
  }
  constexpr Factor kBlack = {0, 0, 0, 0}, kWhite = {1, 1, 1, 1}, kFlat = {0.5, 0.5, 1, 1};
  const auto colour = MapKind::Colour;
  const auto srgb = ColourSpace::Srgb, linear = ColourSpace::Linear;
  addPlan(
      materials,
      {"baseColor", colour, srgb, hasAlpha ? 4 : 3, &GltfMaterial::baseColorTexture, kBlack, {}},
      [](const GltfMaterial& m) {
        Factor factor = m.baseColor;
        if (m.alpha == GltfAlpha::Opaque) factor[3] = 1;
        return factor;
      },
      out.plans, hasVertexColours);
  addPlan(
      materials,
      {"metallicRoughness", colour, linear, 3, &GltfMaterial::metallicRoughnessTexture, kWhite, {}},
      [](const GltfMaterial& m) {
        return Factor{1, m.roughness, m.metallic, 1};
      },
      out.plans);
  addPlan(
      materials, {"occlusion", colour, linear, 1, &GltfMaterial::occlusionTexture, kWhite, {}},
      [&](const GltfMaterial&) { return kWhite; }, out.plans);
  addPlan(
      materials, {"normal", MapKind::Normal, linear, 3, &GltfMaterial::normalTexture, kFlat, {}},
      [](const GltfMaterial& m) {
        return Factor{m.normalScale, m.normalScale, 1, 1};
      },
      out.plans);
  addPlan(
      materials, {"emissive", colour, srgb, 3, &GltfMaterial::emissiveTexture, kBlack, {}},
      [&](const GltfMaterial& m) {
        Factor factor = {0, 0, 0, 1};
        for (std::size_t d = 0; d < 3; ++d) factor[d] = m.emission[d] / out.emissiveStrength;
        return factor;
      },
      out.plans);
  return out;
}

}  // namespace abflat::cli
