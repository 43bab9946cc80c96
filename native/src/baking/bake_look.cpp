#include "baking/bake_look.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace abflat::cli {
namespace {

void noteTangents(const GltfLook& old, const GltfBaked& baked, std::vector<std::string>& notes) {
  const auto count = std::count_if(old.parts.begin(), old.parts.end(),
                                   [](const GltfPart& part) { return part.hasTangents; });
  if (count > 0 && baked.normal != kNoImage)
    notes.push_back("the tangents of " + std::to_string(count) +
                    (count == 1 ? " primitive" : " primitives") +
                    " were those of the old layout, so they were left out: programs "
                    "compute those that the new normal map is made for");
}

/// Into the red of metals with roughness, if there is such an image.
void joinOcclusion(std::vector<BakedMap>& maps, GltfBaked& baked) {
  const auto mapOf = [&](TexturePlace texture) {
    return std::find_if(maps.begin(), maps.end(),
                        [&](const BakedMap& map) { return map.plan.texture == texture; });
  };
  const auto whole = mapOf(kMetallicRoughnessPlace), red = mapOf(kOcclusionPlace);
  if (whole == maps.end() || red == maps.end()) return;
  for (std::size_t i = 0; i < red->image.pixels.size(); ++i)
    whole->image.pixels[3 * i] = red->image.pixels[i];
  baked.occlusion = static_cast<std::size_t>(whole - maps.begin());
  maps.erase(red);
}

void putImage(TexturePlace place, ImageFile file, GltfBaked& baked) {
  const std::size_t number = baked.images.size();
  if (place == &GltfMaterial::baseColorTexture) baked.baseColor = number;
  if (place == kMetallicRoughnessPlace) baked.metallicRoughness = number;
  if (place == kOcclusionPlace) baked.occlusion = number;
  if (place == &GltfMaterial::normalTexture) baked.normal = number;
  if (place == &GltfMaterial::emissiveTexture) baked.emissive = number;
  baked.images.push_back(std::move(file));
}

}  // namespace

Result<OldLook> readOldLook(const gltf::Source& source, const ReadResource& readResource) {
  Result<GltfLook> look = readGltfLook(source, readResource);
  if (!look.ok()) return look.status();
  OldLook out;
  out.look = std::move(look).value();
  if (Status s = out.images.take(out.look.images); !s.ok()) return s;
  return out;
}

Result<NewLook> bakeLook(OldLook& old, const NewLayout& layout, const BakeOptionValues& options) {
  const auto start = std::chrono::steady_clock::now();
  Result<BakedMaps> baked = bakeMaps(old, layout, options);
  if (!baked.ok()) return baked.status();
  std::vector<BakedMap>& maps = baked.value().maps;
  NewLook out;
  joinOcclusion(maps, out.baked);
  for (const BakedMap& map : maps) {
    Result<ImageFile> file = writeMap(map, options, out.report, out.notes);
    if (!file.ok()) return file.status();
    putImage(map.plan.texture, std::move(file).value(), out.baked);
  }
  out.baked.emissiveStrength = baked.value().emissiveStrength;
  noteTangents(old.look, out.baked, out.notes);
  noteOld(old, maps.empty(), out.report, out.notes);
  out.report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return out;
}

}  // namespace abflat::cli
