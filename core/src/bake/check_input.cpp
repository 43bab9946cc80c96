#include "bake/check_input.h"

#include <cmath>
#include <string>

#include "base/invalid.h"

namespace abflat {
namespace {

Status invalidMesh(std::string text) { return {StatusCode::InvalidMesh, std::move(text)}; }

bool isPixelFormat(int channels, int bits) {
  return channels >= 1 && channels <= 4 && (bits == 8 || bits == 16);
}

bool isSide(std::uint32_t texels) { return texels >= 1 && texels <= kMostBakedTexels; }

template <class T>
bool areFinite(const T& values) {
  for (const auto x : values)
    if (!std::isfinite(x)) return false;
  return true;
}

Status checkTriangles(const BakeTriangles& triangles, std::size_t materials, MapKind kind) {
  const std::size_t count = triangles.materials.size();
  if (triangles.uv.size() != 6 * count || triangles.oldUv.size() != 6 * count)
    return invalidMesh("each triangle needs 6 numbers in uv and in oldUv, and a material");
  if (!triangles.colours.empty() && triangles.colours.size() != 12 * count)
    return invalidMesh("each triangle needs 12 numbers in colours, or there are none");
  if (kind == MapKind::Normal &&
      (triangles.normals.size() != 9 * count || triangles.tangents.size() != 12 * count ||
       triangles.oldTangents.size() != 12 * count))
    return invalidMesh(
        "for a normal map each triangle needs 9 numbers in normals, and 12 in tangents and in "
        "oldTangents");
  for (std::size_t t = 0; t < count; ++t)
    if (triangles.materials[t] >= materials)
      return invalidMesh("triangle " + std::to_string(t) + " has a material that does not exist");
  for (std::size_t i = 0; i < triangles.colours.size(); ++i)
    if (!std::isfinite(triangles.colours[i]))
      return invalidMesh("triangle " + std::to_string(i / 12) + " has colours that are not finite");
  for (const std::vector<double>* values : {&triangles.uv, &triangles.oldUv})
    for (std::size_t i = 0; i < values->size(); ++i)
      if (!std::isfinite((*values)[i]))
        return invalidMesh("triangle " + std::to_string(i / 6) + " has uv that are not finite");
  return {};
}

}  // namespace

Status checkInput(const BakeInput& input, MapKind kind) {
  for (std::size_t i = 0; i < input.textures.size(); ++i) {
    const ImageView& image = input.textures[i].image;
    if (!image.pixels || !isSide(image.width) || !isSide(image.height) ||
        !isPixelFormat(image.channels, image.bits))
      return invalid("texture " + std::to_string(i) +
                     " needs pixels of 1 to 4 channels of 8 or 16 bits, and 1 to " +
                     std::to_string(kMostBakedTexels) + " of them a side");
  }
  for (std::size_t i = 0; i < input.materials.size(); ++i) {
    const BakeMaterial& material = input.materials[i];
    if (material.texture != kNoTexture && material.texture >= input.textures.size())
      return invalid("material " + std::to_string(i) + " has a texture that does not exist");
    if (!areFinite(material.offset) || !areFinite(material.scale) || !areFinite(material.factor) ||
        !std::isfinite(material.rotation))
      return invalid("material " + std::to_string(i) + " has numbers that are not finite");
  }
  return checkTriangles(input.triangles, input.materials.size(), kind);
}

Status checkOptions(const BakeOptions& options) {
  if (!isSide(options.width) || !isSide(options.height))
    return invalid("width and height must be from 1 to " + std::to_string(kMostBakedTexels));
  if (!isPixelFormat(options.channels, options.bits))
    return invalid("an image has 1 to 4 channels of 8 or 16 bits");
  if (options.bandRows == 0) return invalid("bandRows must be at least 1");
  if (options.threads < 0 || options.threads > 256) return invalid("threads must be from 0 to 256");
  if (!areFinite(options.background)) return invalid("background must be finite");
  return {};
}

}  // namespace abflat
