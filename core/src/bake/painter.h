#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "abflat/bake.h"
#include "bake/owners.h"
#include "bake/sampler.h"
#include "bake/texel_footprint.h"
#include "bake/texel_triangle.h"
#include "base/parallel.h"
#include "base/point2.h"
#include "base/portable_math.h"

namespace abflat {

/// Where a material has its textures.
class UvTransform {
 public:
  explicit UvTransform(const BakeMaterial& material);
  /// The place in the texture of a point's uv.
  Point2 at(const double* uv) const;

 private:
  Point2 scale_, offset_;
  portable::SinCos turn_;
};

/// Where the texels of a triangle lie in its old texture.
struct OldPlace {
  Point2 first{};            ///< of its corners, in texels of the texture
  Point2 second{}, third{};  ///< from the first to the others
  Jacobian jacobian{};
};

/// `uv`: 2 per corner of a triangle with these weights.
OldPlace oldPlace(const double* uv, const UvTransform& transform, const CornerWeights& weights,
                  const ImageView& texture);

/// What colours the texels of one triangle.
struct Brush {
  std::uint32_t triangle = 0;
  TexelTriangle corners;
  CornerWeights weights;
  bool isSpeck = false;
  const BakeMaterial* material = nullptr;
  const Sampler* sampler = nullptr;  ///< null: a constant
  OldPlace place{};
  TexelFootprint footprint{};
};

/// Colours texels as one map asks for. Textures are prepared once.
class Painter {
 public:
  /// `layout`: the triangles of the input.
  Painter(const BakeInput& input, MapKind kind, const BandedTriangles& layout, ThreadPool& pool);

  Brush brush(std::uint32_t t, const TexelTriangle& corners, bool isSpeck) const;

  /// The colour of the texel with its centre at (x, y); of a normal map, with a vector as a colour.
  Colour colour(const Brush& brush, double x, double y) const;

 private:
  const Codec& codecOf(const BakeTexture& texture);
  Colour vector(const Brush& brush, const CornerWeights::Weights& weights, Colour texel) const;

  const BakeInput& input_;
  MapKind kind_;
  std::vector<UvTransform> transforms_;             ///< by material
  std::array<std::optional<Codec>, 4> codecs_;      ///< those in use, by space and bits
  std::vector<std::unique_ptr<Sampler>> samplers_;  ///< by texture; null: not used
};

}  // namespace abflat
