#pragma once

#include <cstdint>
#include <vector>

#include "abflat/bake.h"
#include "bake/codec.h"
#include "bake/colour.h"
#include "bake/pyramid.h"
#include "bake/texel_footprint.h"
#include "bake/texels.h"
#include "base/point2.h"

namespace abflat {

/// Reads a texture anywhere, filtered.
class Sampler {
 public:
  /// The texture and `codec`, which belongs to it, are to live as long. `reductions`: of the
  /// pyramid.
  Sampler(const BakeTexture& texture, const Codec& codec, int reductions);

  int reductions() const { return static_cast<int>(pyramid_.levels.size()) - 1; }

  /// The place in the first repetition of the texture that looks like (x, y).
  Point2 inFirstPeriod(const Point2& place) const;

  /// The linear colour around a point, in texels of the first level.
  Colour at(double x, double y, const TexelFootprint& footprint) const {
    return read_(*this, x, y, footprint);
  }

 private:
  template <class Texel>
  static Colour read(const Sampler& sampler, double x, double y, const TexelFootprint& footprint);
  template <class Texel>
  Colour bilinear(std::size_t level, double x, double y) const;

  struct Grid {
    const void* pixels;
    std::int64_t width, height;
    double scaleX, scaleY;  ///< its texels to one of the first level
  };

  Pyramid pyramid_;
  std::vector<Grid> grids_;  ///< of the levels
  Decoding decoding_;
  Wrap wrapU_, wrapV_;
  Colour (*read_)(const Sampler&, double, double, const TexelFootprint&);
};

}  // namespace abflat
