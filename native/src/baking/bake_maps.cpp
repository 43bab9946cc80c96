#include "baking/bake_maps.h"

#include <algorithm>
#include <utility>

#include "baking/corners.h"

namespace abflat::cli {
namespace {

class MapsBaker {
 public:
  MapsBaker(OldLook& old, const NewLayout& layout, const BakeOptionValues& options)
      : old_(old),
        layout_(layout),
        options_(options),
        plans_(planMaps(old.look.materials, !old.look.colours.empty())),
        corners_(old.look, layout) {}

  Result<BakedMaps> bakeAll() {
    std::vector<AtlasSize> sizes;
    for (const MapPlan& plan : plans_.plans) sizes.push_back(sizeOf(plan));
    shareSize(sizes);
    for (std::size_t i = 0; i < sizes.size(); ++i)
      if (Status s = bakeMap(plans_.plans[i], sizes[i]); !s.ok()) return s;
    out_.emissiveStrength = plans_.emissiveStrength;
    return std::move(out_);
  }

 private:
  /// Everything but pixels, and the frames of normal maps.
  BakeInput inputOf(const MapPlan& plan) const {
    BakeInput input;
    input.triangles.uv = corners_.uv();
    input.triangles.oldUv = corners_.oldUv(plan.texture);
    if (plan.texture == &GltfMaterial::baseColorTexture)
      input.triangles.colours = corners_.colours();
    for (std::size_t f = 0; f < corners_.faces(); ++f)
      input.triangles.materials.push_back(static_cast<std::uint32_t>(corners_.materialOf(f)));
    for (std::size_t m = 0; m < old_.look.materials.size(); ++m) {
      const GltfMaterial& material = old_.look.materials[m];
      const GltfTexture& use = material.*plan.texture;
      BakeMaterial& now = input.materials.emplace_back();
      now.factor = plan.factors[m];
      if (use.image == kNoImage) continue;
      now.offset = use.offset;
      now.rotation = use.rotation;
      now.scale = use.scale;
      now.texture = static_cast<std::uint32_t>(input.textures.size());
      input.textures.push_back(textureOf(plan, material, use));
    }
    return input;
  }

  BakeTexture textureOf(const MapPlan& plan, const GltfMaterial& material,
                        const GltfTexture& use) const {
    BakeTexture out;
    const images::Size size = old_.images.size(use.image);
    out.image.width = size.width;
    out.image.height = size.height;
    out.wrapU = use.wrapU;
    out.wrapV = use.wrapV;
    out.space = plan.space;
    out.alphaIsOpacity = plan.channels == 4 && material.alpha != GltfAlpha::Opaque;
    return out;
  }

  Result<ImageView> pixelsOf(const MapPlan& plan, const GltfMaterial& material) {
    const std::size_t image = (material.*plan.texture).image;
    if (plan.texture == kOcclusionPlace)
      return old_.images.occlusion(image, material.occlusionStrength);
    const bool lacksAlpha = plan.channels == 4 && material.alpha == GltfAlpha::Opaque;
    return lacksAlpha ? old_.images.opaque(image) : old_.images.whole(image);
  }

  /// Materials that use an image alike then share it, since each takes memory.
  Status addPixels(const MapPlan& plan, BakeInput& input) {
    std::vector<BakeTexture> shared;
    for (std::size_t m = 0; m < input.materials.size(); ++m) {
      std::uint32_t& number = input.materials[m].texture;
      if (number == kNoTexture) continue;
      BakeTexture& texture = input.textures[number];
      Result<ImageView> pixels = pixelsOf(plan, old_.look.materials[m]);
      if (!pixels.ok()) return pixels.status();
      texture.image = pixels.value();
      const auto found = std::find_if(shared.begin(), shared.end(), [&](const BakeTexture& other) {
        return other.image.pixels == texture.image.pixels && other.wrapU == texture.wrapU &&
               other.wrapV == texture.wrapV && other.alphaIsOpacity == texture.alphaIsOpacity;
      });
      number = static_cast<std::uint32_t>(found - shared.begin());
      if (found == shared.end()) shared.push_back(texture);
    }
    input.textures = std::move(shared);
    return {};
  }

  AtlasSize sizeOf(const MapPlan& plan) const {
    const bool isAuto = options_.bakeResolution == kAutoBakeResolution;
    return bakeSize(isAuto ? inputOf(plan) : BakeInput(), options_.bakeResolution,
                    layout_.resolution);
  }

  std::size_t planOf(TexturePlace texture) const {
    std::size_t i = 0;
    while (i < plans_.plans.size() && plans_.plans[i].texture != texture) ++i;
    return i;
  }

  /// Metals, roughness and occlusion are one image, so they have one size.
  void shareSize(std::vector<AtlasSize>& sizes) const {
    const std::size_t a = planOf(kMetallicRoughnessPlace), b = planOf(kOcclusionPlace);
    if (a < sizes.size() && b < sizes.size())
      sizes[a] = sizes[b] = sizes[a].width < sizes[b].width ? sizes[b] : sizes[a];
  }

  Status bakeMap(const MapPlan& plan, const AtlasSize& size) {
    BakeInput input = inputOf(plan);
    if (Status s = addPixels(plan, input); !s.ok()) return s;
    if (plan.kind == MapKind::Normal) {
      const FrameMesh& frames = corners_.frames();
      BakeTriangles& now = input.triangles;
      now.normals = cornerNormals(frames);
      now.oldTangents = oldTangents(frames, now.oldUv, now.normals);
      now.tangents = newTangents(frames, now.uv, now.normals);
    }
    BakeOptions options;
    options.kind = plan.kind;
    options.width = static_cast<std::uint32_t>(size.width);
    options.height = static_cast<std::uint32_t>(size.height);
    options.channels = plan.channels;
    options.space = plan.space;
    options.background = plan.background;
    options.padding = bakePadding(layout_.padding, size, layout_.resolution);
    options.threads = options_.threads;
    BakedMap& map = out_.maps.emplace_back();
    map.plan = plan;
    map.image = {options.width, options.height, plan.channels, options.bits, {}};
    map.image.pixels.reserve(std::size_t{options.width} * options.height *
                             static_cast<std::size_t>(plan.channels));
    Status status = bake(input, options, [&](auto, auto, const std::vector<std::uint8_t>& rows) {
      map.image.pixels.insert(map.image.pixels.end(), rows.begin(), rows.end());
      return true;
    });
    old_.images.release();
    return status;
  }

  OldLook& old_;
  const NewLayout& layout_;
  const BakeOptionValues& options_;
  const MapPlans plans_;
  const Corners corners_;
  BakedMaps out_;
};

}  // namespace

Result<BakedMaps> bakeMaps(OldLook& old, const NewLayout& layout, const BakeOptionValues& options) {
  return MapsBaker(old, layout, options).bakeAll();
}

Result<ImageFile> writeMap(const BakedMap& map, const BakeOptionValues& options,
                           BakingReport& report, std::vector<std::string>& notes) {
  ImageFormat format = options.imageFormat;
  if (format == ImageFormat::Jpeg && map.plan.channels == 4) {
    format = ImageFormat::Png;
    notes.push_back(std::string(map.plan.name) +
                    " is a PNG, because it has alpha, which JPEG does not hold");
  }
  // WebP keeps the colours of half as many pixels, which is nothing for numbers.
  const bool isExact = format == ImageFormat::Webp && !map.plan.holdsColours();
  Result<std::string> file =
      images::writeImage(map.image, format, isExact ? 100 : options.imageQuality);
  if (!file.ok()) return file.status();
  const auto width = static_cast<int>(map.image.width), height = static_cast<int>(map.image.height);
  report.maps.push_back(
      {map.plan.name, std::max(width, height), width, height, format, file.value().size()});
  return ImageFile{map.plan.name, images::mimeTypeOf(format), std::move(file).value()};
}

void noteOld(const OldLook& old, bool hasNone, BakingReport& report,
             std::vector<std::string>& notes) {
  report.materials = old.look.materials.size();
  report.images = old.images.count();
  if (hasNone)
    notes.emplace_back(
        "nothing was baked: no material of the mesh has a texture, and no vertex has a colour");
  if (std::string note = depthNote(old.images.deep().size()); !note.empty())
    notes.push_back(std::move(note));
}

}  // namespace abflat::cli
