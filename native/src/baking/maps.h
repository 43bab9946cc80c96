#pragma once

#include <array>
#include <vector>

#include "abflat/bake.h"
#include "abflat/gltf_look.h"

namespace abflat::cli {

/// Where a material has the texture of a map, which also tells the maps apart.
using TexturePlace = GltfTexture GltfMaterial::*;
constexpr TexturePlace kMetallicRoughnessPlace = &GltfMaterial::metallicRoughnessTexture,
                       kOcclusionPlace = &GltfMaterial::occlusionTexture;

/// A map of materials, and how an image holds it.
struct MapPlan {
  const char* name;
  MapKind kind;
  ColourSpace space;
  int channels;
  TexturePlace texture;
  std::array<double, 4> background;            ///< as in BakeOptions
  std::vector<std::array<double, 4>> factors;  ///< by material, as in BakeMaterial

  bool holdsColours() const { return space == ColourSpace::Srgb; }
};

/// What maps the materials need: those that one of them has a texture for, or that are more than
/// one number for all, as the base colour is where vertices have colours.
struct MapPlans {
  std::vector<MapPlan> plans;
  double emissiveStrength = 1;  ///< what the emissive map is to be multiplied by
};

MapPlans planMaps(const std::vector<GltfMaterial>& materials, bool hasVertexColours);

}  // namespace abflat::cli
