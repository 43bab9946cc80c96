#include "baking/bake_look.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "baking/corners.h"
#include "baking/maps.h"

namespace abflat::cli {
namespace {

constexpr TexturePlace kMetallicRoughness = &GltfMaterial::metallicRoughnessTexture,
                       kOcclusion = &GltfMaterial::occlusionTexture;

struct BakedImage {
  const MapPlan* plan;
  images::Image image;
};

class LookBaker {
 public:
  LookBaker(OldLook& old, const NewLayout& layout, const BakeOptionValues& options)
      : old_(old),
        layout_(layout),
        options_(options),
        plans_(planMaps(old.look.materials)),
        corners_(old.look, layout) {}

  Result<NewLook> bakeAll() {
    const auto start = std::chrono::steady_clock::now();
    std::vector<int> sides;
    for (const MapPlan& plan : plans_.plans) sides.push_back(sideOf(plan));
    shareSide(sides);
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (Status s = bakeMap(plans_.plans[i], sides[i]); !s.ok()) return s;
    joinOcclusion();
    for (const BakedImage& map : maps_)
      if (Status s = write(map); !s.ok()) return s;
    out_.baked.emissiveStrength = plans_.emissiveStrength;
    out_.report.materials = old_.look.materials.size();
    out_.report.images = old_.images.count();
    if (maps_.empty())
      out_.notes.emplace_back("nothing was baked: no material of the mesh has a texture");
    noteTangents();
    out_.report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(out_);
  }

 private:
  /// Everything but pixels, and the frames of normal maps.
  BakeInput inputOf(const MapPlan& plan) const {
    BakeInput input;
    input.triangles.uv = corners_.uv();
    input.triangles.oldUv = corners_.oldUv(plan.texture);
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
    if (plan.texture == kOcclusion) return old_.images.occlusion(image, material.occlusionStrength);
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

  int sideOf(const MapPlan& plan) const {
    if (options_.bakeResolution != kAutoBakeResolution) return options_.bakeResolution;
    return bakeSide(inputOf(plan), layout_.resolution);
  }

  std::size_t planOf(TexturePlace texture) const {
    std::size_t i = 0;
    while (i < plans_.plans.size() && plans_.plans[i].texture != texture) ++i;
    return i;
  }

  /// Metals, roughness and occlusion are one image, so they have one size.
  void shareSide(std::vector<int>& sides) const {
    const std::size_t a = planOf(kMetallicRoughness), b = planOf(kOcclusion);
    if (a < sides.size() && b < sides.size()) sides[a] = sides[b] = std::max(sides[a], sides[b]);
  }

  Status bakeMap(const MapPlan& plan, int side) {
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
    options.width = options.height = static_cast<std::uint32_t>(side);
    options.channels = plan.channels;
    options.space = plan.space;
    options.background = plan.background;
    const double scale = layout_.resolution == 0 ? 1 : double(side) / layout_.resolution;
    options.padding = static_cast<std::uint32_t>(std::ceil(layout_.padding * scale));
    options.threads = options_.threads;
    BakedImage& map = maps_.emplace_back();
    map.plan = &plan;
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

  void noteTangents() {
    const auto count = std::count_if(old_.look.parts.begin(), old_.look.parts.end(),
                                     [](const GltfPart& part) { return part.hasTangents; });
    if (count > 0 && out_.baked.normal != kNoImage)
      out_.notes.push_back("the tangents of " + std::to_string(count) +
                           (count == 1 ? " primitive" : " primitives") +
                           " were those of the old layout, so they were left out: programs "
                           "compute those that the new normal map is made for");
  }

  void joinOcclusion() {
    const auto mapOf = [&](TexturePlace texture) {
      return std::find_if(maps_.begin(), maps_.end(),
                          [&](const BakedImage& map) { return map.plan->texture == texture; });
    };
    const auto whole = mapOf(kMetallicRoughness), red = mapOf(kOcclusion);
    if (whole == maps_.end() || red == maps_.end()) return;
    for (std::size_t i = 0; i < red->image.pixels.size(); ++i)
      whole->image.pixels[3 * i] = red->image.pixels[i];
    out_.baked.occlusion = static_cast<std::size_t>(whole - maps_.begin());
    maps_.erase(red);
  }

  Status write(const BakedImage& map) {
    ImageFormat format = options_.imageFormat;
    if (format == ImageFormat::Jpeg && map.plan->channels == 4) {
      format = ImageFormat::Png;
      out_.notes.push_back(std::string(map.plan->name) +
                           " is a PNG, because it has alpha, which JPEG does not hold");
    }
    // WebP keeps the colours of half as many pixels, which is nothing for numbers.
    const bool isExact = format == ImageFormat::Webp && !map.plan->holdsColours();
    Result<std::string> file =
        images::writeImage(map.image, format, isExact ? 100 : options_.imageQuality);
    if (!file.ok()) return file.status();
    const std::size_t number = out_.baked.images.size();
    const TexturePlace place = map.plan->texture;
    if (place == &GltfMaterial::baseColorTexture) out_.baked.baseColor = number;
    if (place == kMetallicRoughness) out_.baked.metallicRoughness = number;
    if (place == kOcclusion) out_.baked.occlusion = number;
    if (place == &GltfMaterial::normalTexture) out_.baked.normal = number;
    if (place == &GltfMaterial::emissiveTexture) out_.baked.emissive = number;
    out_.report.maps.push_back(
        {map.plan->name, static_cast<int>(map.image.width), format, file.value().size()});
    out_.baked.images.push_back(
        {map.plan->name, images::mimeTypeOf(format), std::move(file).value()});
    return {};
  }

  OldLook& old_;
  const NewLayout& layout_;
  const BakeOptionValues& options_;
  const MapPlans plans_;
  const Corners corners_;
  std::vector<BakedImage> maps_;
  NewLook out_;
};

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
  return LookBaker(old, layout, options).bakeAll();
}

}  // namespace abflat::cli
