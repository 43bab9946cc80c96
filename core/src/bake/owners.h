#pragma once

#include <cstdint>
#include <vector>

#include "bake/texel_triangle.h"

namespace abflat {

/// The triangles of a layout, in the texels of the new image, by the bands of rows they touch.
class BandedTriangles {
 public:
  /// `uv`: 2 per corner. Those without area are left out.
  BandedTriangles(const std::vector<double>& uv, std::uint32_t width, std::uint32_t height,
                  std::uint32_t bandRows);

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  std::size_t bandCount() const { return firstOfBand_.size() - 1; }
  /// Rows of a band.
  TexelRange rows(std::size_t band) const;
  /// The same with a row more on either side.
  TexelRange rowsAround(std::size_t band) const;

  /// The triangles in the rows around a band, ascending.
  const std::uint32_t* begin(std::size_t band) const { return &inBand_[firstOfBand_[band]]; }
  std::size_t countIn(std::size_t band) const {
    return firstOfBand_[band + 1] - firstOfBand_[band];
  }

  TexelTriangle triangle(std::uint32_t t) const;
  /// Whether it is so small that no texel has its centre in it.
  bool isSpeck(std::uint32_t t) const { return isSpeck_[t] != 0; }

 private:
  /// Bands whose rows, and those around, a triangle touches.
  TexelRange bandsOf(const TexelTriangle& triangle) const;

  const std::vector<double>& uv_;
  std::uint32_t width_, height_, bandRows_;
  std::vector<std::uint8_t> isSpeck_;
  std::vector<std::size_t> firstOfBand_;
  std::vector<std::uint32_t> inBand_;  ///< one more than there are
};

/// No triangle.
constexpr std::uint32_t kNoOwner = 0xffffffffu;

/// Which triangle colours each texel of the rows around a band, as its number in the band: the
/// first one that the centre lies in, otherwise the first speck that touches it.
std::vector<std::uint32_t> ownersAround(const BandedTriangles& triangles, std::size_t band);

}  // namespace abflat
