#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "abflat/appearance.h"
#include "abflat/bake.h"
#include "abflat/export.h"
#include "abflat/gltf.h"
#include "abflat/status.h"

// What a glTF file says about the look of its mesh, as far as bake needs it.

namespace abflat {

/// How a material uses an image.
struct GltfTexture {
  std::size_t image = kNoImage;  ///< in GltfLook::images; kNoImage: there is no texture
  std::size_t texcoord = 0;      ///< in GltfLook::texcoords
  Wrap wrapU = Wrap::Repeat, wrapV = Wrap::Repeat;
  std::array<double, 2> offset = {0, 0}, scale = {1, 1};
  double rotation = 0;  ///< as in BakeMaterial
};

enum class GltfAlpha { Opaque, Mask, Blend };

struct GltfMaterial {
  std::array<double, 4> baseColor = {1, 1, 1, 1};
  std::array<double, 3> emission = {0, 0, 0};  ///< above 1 with KHR_materials_emissive_strength
  double metallic = 1, roughness = 1;
  double normalScale = 1, occlusionStrength = 1;
  GltfAlpha alpha = GltfAlpha::Opaque;
  GltfTexture baseColorTexture, metallicRoughnessTexture, normalTexture, occlusionTexture,
      emissiveTexture;
};

/// Triangles of the mesh that come from one primitive, in order.
struct GltfPart {
  std::uint32_t firstFace = 0, faceCount = 0;
  std::size_t material = 0;  ///< in GltfLook::materials
  bool isMirrored = false;   ///< corners 1 and 2 of the mesh are the other way round in the file
  bool hasTangents = false;
};

struct GltfLook {
  std::vector<GltfMaterial> materials;
  std::vector<ImageFile> images;  ///< those that materials use; named by their place in the file
  std::vector<GltfPart> parts;
  std::vector<std::uint32_t> corners;  ///< vertex of each corner of the mesh as it was read
  /// By set that a texture uses, 2 numbers per vertex, v downwards; a set that no texture uses is
  /// empty, and a vertex without texcoords is at 0.
  std::vector<std::vector<double>> texcoords;
  /// Per vertex, linear red, green, blue and alpha, which multiply the base colour; 1 where its
  /// primitive has none. Empty if none has any.
  std::vector<float> colours;
  // Per vertex, in the coordinates of its primitive; empty if there is no normal map.
  std::vector<double> positions;  ///< 3 numbers
  std::vector<float> normals;     ///< 3 numbers of any length; all 0 if there is none
  std::vector<float> tangents;    ///< 4 numbers, in parts that have them
};

/// Reads the materials of the mesh's faces, and the images that they use. Errors: ParseError,
/// UnreadableFile (an image it refers to).
ABFLAT_API Result<GltfLook> readGltfLook(const gltf::Source& source,
                                         const ReadResource& readResource);

}  // namespace abflat
