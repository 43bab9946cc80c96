// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "abflat/generated/bake_options.h"

namespace abflat {

/// An image that was baked.
struct BakedMap {
  /// What it holds: baseColor, metallicRoughness with occlusion in red, occlusion, normal or
  /// emissive; of an OBJ: diffuse, opacity, roughness and so on.
  std::string map;
  /// Texels along the longer side.
  int resolution = 0;
  /// Texels of a row.
  int width = 0;
  /// Number of rows.
  int height = 0;
  /// The format of its file.
  ImageFormat format = ImageFormat::Png;
  /// Size of its file.
  std::size_t bytes = 0;
};

template <class Visitor>
void visitFields(const BakedMap& r, Visitor& v) {
  v.field("map", r.map);
  v.field("resolution", r.resolution);
  v.field("width", r.width);
  v.field("height", r.height);
  v.field("format", r.format);
  v.field("bytes", r.bytes);
}

/// What became of the old textures.
struct BakingReport {
  /// The new images.
  std::vector<BakedMap> maps;
  /// Materials of the mesh before.
  std::size_t materials = 0;
  /// Images that they used.
  std::size_t images = 0;
  /// Time to read the old images, and to make and write the new ones, in seconds.
  double seconds = 0;
};

template <class Visitor>
void visitFields(const BakingReport& r, Visitor& v) {
  v.field("maps", r.maps);
  v.field("materials", r.materials);
  v.field("images", r.images);
  v.field("seconds", r.seconds);
}

}  // namespace abflat
