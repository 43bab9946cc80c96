#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "abflat/status.h"
#include "draw/atlas_polygons.h"
#include "draw/band.h"

namespace abflat {

/// Which part of uv a picture shows, and how large.
struct PictureFrame {
  int width = 0, height = 0;  ///< pixels
  double left = 0, top = 1;   ///< the upper left corner in uv
  double perU = 0, perV = 0;  ///< pixels

  /// v points up, rows count down.
  PixelPoint at(const double* uv) const { return {(uv[0] - left) * perU, (top - uv[1]) * perV}; }
};

struct PaintedLayout {
  const std::vector<double>& uv;
  const std::vector<std::uint32_t>& cornerUv;  ///< per face corner
  AtlasPolygons areas;
  AtlasEdges edges;
  std::vector<PixelPoint> marks = {};  ///< places to draw a ring around
};

struct PaintOptions {
  bool hasInnerEdges = true;
  std::function<Rgb(std::uint32_t)> colourOf;  ///< of an area, by its index
};

/// A PNG file, transparent where nothing lies. It is made band by band, so that the memory it takes
/// does not grow with its height.
Result<std::string> paintLayout(const PaintedLayout& layout, const PictureFrame& frame,
                                const PaintOptions& options);

}  // namespace abflat
