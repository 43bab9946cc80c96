#include <algorithm>

#include "abflat/draw.h"
#include "base/guarded.h"
#include "draw/colours.h"
#include "draw/face_areas.h"
#include "draw/layout_painter.h"

namespace abflat {
namespace {

/// All tiles side by side, a pixel per texel.
PictureFrame tilesFrame(const AtlasReport& atlas) {
  PictureFrame out;
  out.width = atlas.width * tileColumns(atlas);
  out.height = atlas.height * tileRows(atlas);
  out.top = tileRows(atlas);
  out.perU = atlas.width;
  out.perV = atlas.height;
  return out;
}

/// `colourOf` gives the colour of a face.
Result<std::string> atlasPicture(const PolygonMesh& mesh, const UnwrapResult& result,
                                 const std::function<Rgb(std::uint32_t)>& colourOf,
                                 bool hasInnerEdges) {
  const PictureFrame frame = tilesFrame(result.report.atlas);
  // Both sides are at most 2^16 texels times 900 rows.
  if (std::max(frame.width, frame.height) > kMostPictureTexels)
    return Status{StatusCode::InvalidOption,
                  "pictures have at most " + std::to_string(kMostPictureTexels) +
                      " pixels along a side. Lower the resolution, or use SVG"};
  AtlasPolygons polygons = atlasPolygons(mesh, result, Stacked::LeftOut);
  AtlasEdges edges = atlasEdges(polygons, result.cornerUv);
  const PaintedLayout layout{result.uv, result.cornerUv, std::move(polygons), std::move(edges)};
  return paintLayout(layout, frame, {hasInnerEdges, [&](std::uint32_t i) {
                                       return colourOf(layout.areas.face[i]);
                                     }});
}

Result<std::string> chartPng(const PolygonMesh& mesh, const UnwrapResult& result) {
  return atlasPicture(
      mesh, result, [&](std::uint32_t f) { return chartColour(result.chartOfFace[f]); }, true);
}

Result<std::string> ratioPng(const PolygonMesh& mesh, const UnwrapResult& result) {
  const FaceAreas areas = faceAreas(mesh, result);
  const double scale = areas.uvSum > 0 ? areas.sum / areas.uvSum : 0;
  return atlasPicture(
      mesh, result,
      [&](std::uint32_t f) {
        if (!(areas.in3d[f] > 0) || !(areas.inUv[f] > 0)) return parseColour("#808080");
        return ratioColour(scale * areas.inUv[f] / areas.in3d[f]);
      },
      false);
}

}  // namespace

Result<std::string> atlasPng(const PolygonMesh& mesh, const UnwrapResult& result) {
  return guarded([&] { return chartPng(mesh, result); });
}

Result<std::string> heatMapPng(const PolygonMesh& mesh, const UnwrapResult& result) {
  return guarded([&] { return ratioPng(mesh, result); });
}

}  // namespace abflat
