#include "baking/obj_baker.h"

#include <algorithm>
#include <utility>

namespace abflat::cli {

ObjBaker::ObjBaker(OldObj& old, const PolygonMesh& mesh, const NewLayout& layout,
                   const std::vector<std::uint32_t>& triangleCorners,
                   const BakeOptionValues& options, const std::vector<double>& colours)
    : old_(old),
      layout_(layout),
      options_(options),
      corners_(mesh, layout, triangleCorners),
      colours_(colours) {}

AtlasSize ObjBaker::sizeOf(const ObjPlan& plan) const {
  const bool isAuto = options_.bakeResolution == kAutoBakeResolution;
  return bakeSize(isAuto ? inputOf(plan) : BakeInput(), options_.bakeResolution,
                  layout_.resolution);
}

/// Everything but pixels, and the frames of normal maps.
BakeInput ObjBaker::inputOf(const ObjPlan& plan) const {
  BakeInput input;
  input.triangles = corners_.triangles();
  for (const std::optional<ObjUse>& use : plan.uses) {
    BakeMaterial& now = input.materials.emplace_back();
    if (!use) continue;
    now.scale = use->scale;
    // From v upwards to v downwards.
    now.offset = {use->offset[0], 1 - use->scale[1] - use->offset[1]};
    now.texture = static_cast<std::uint32_t>(input.textures.size());
    BakeTexture& texture = input.textures.emplace_back();
    const images::Size size = old_.images.size(use->image);
    texture.image.width = size.width;
    texture.image.height = size.height;
    texture.wrapU = texture.wrapV = use->isClamped ? Wrap::Clamp : Wrap::Repeat;
    texture.space = plan.space;
    texture.alphaIsOpacity = plan.space == ColourSpace::Srgb && plan.channels == 4;
  }
  if (input.materials.empty()) input.materials.emplace_back();  // faces without any
  return input;
}

Status ObjBaker::addPixels(const ObjPlan& plan, BakeInput& input) {
  for (std::size_t m = 0; m < plan.uses.size(); ++m) {
    if (!plan.uses[m]) continue;
    const Result<ImageView> pixels = old_.images.whole(plan.uses[m]->image);
    if (!pixels.ok()) return pixels.status();
    input.textures[input.materials[m].texture].image = pixels.value();
  }
  return {};
}

Result<images::Image> ObjBaker::bake(const ObjPlan& plan, const AtlasSize& size, int bits) {
  BakeInput input = inputOf(plan);
  if (Status s = addPixels(plan, input); !s.ok()) return s;
  if (plan.kind == MapKind::Normal) corners_.addFrames(input.triangles);
  if (plan.hasVertexColours) input.triangles.colours = corners_.colours(colours_);
  BakeOptions options;
  options.kind = plan.kind;
  options.width = static_cast<std::uint32_t>(size.width);
  options.height = static_cast<std::uint32_t>(size.height);
  options.channels = plan.channels;
  options.bits = bits;
  options.space = plan.space;
  if (plan.kind == MapKind::Normal) options.background = {0.5, 0.5, 1, 1};
  options.padding = bakePadding(layout_.padding, size, layout_.resolution);
  options.threads = options_.threads;
  images::Image out{options.width, options.height, plan.channels, bits, {}};
  out.pixels.reserve(std::size_t{options.width} * options.height *
                     static_cast<std::size_t>(plan.channels * bits / 8));
  const Status status =
      abflat::bake(input, options, [&](auto, auto, const std::vector<std::uint8_t>& rows) {
        out.pixels.insert(out.pixels.end(), rows.begin(), rows.end());
        return true;
      });
  old_.images.release();
  if (!status.ok()) return status;
  return out;
}

Result<ImageFile> ObjBaker::write(const images::Image& image, const ObjPlan& plan,
                                  ImageFormat format, BakingReport& report) const {
  // WebP keeps the colours of half as many pixels, which is nothing for numbers.
  const bool isExact = format == ImageFormat::Webp && plan.space == ColourSpace::Linear;
  Result<std::string> file =
      images::writeImage(image, format, isExact ? 100 : options_.imageQuality);
  if (!file.ok()) return file.status();
  const auto width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  report.maps.push_back(
      {plan.name, std::max(width, height), width, height, format, file.value().size()});
  return ImageFile{plan.name, images::mimeTypeOf(format), std::move(file).value()};
}

ImageFormat formatFor(const ObjPlan& plan, ImageFormat wanted, std::vector<std::string>& notes) {
  if (wanted != ImageFormat::Jpeg || plan.channels != 4) return wanted;
  notes.push_back(plan.name + " is a PNG, because it has alpha, which JPEG does not hold");
  return ImageFormat::Png;
}

}  // namespace abflat::cli
