#include <algorithm>
#include <cmath>
#include <functional>

#include "abflat/draw.h"
#include "base/guarded.h"
#include "draw/atlas_polygons.h"
#include "draw/band.h"
#include "draw/colours.h"
#include "draw/face_areas.h"
#include "draw/png_writer.h"
#include "draw/theme.h"

namespace abflat {
namespace {

constexpr double kThin = 1, kThick = 2;  // pixels
constexpr int kBandRows = 64;

using Point = PixelPoint;

/// Draws an atlas band by band, so that the memory it takes does not grow with its height.
class AtlasPainter {
 public:
  AtlasPainter(const PolygonMesh& mesh, const UnwrapResult& result)
      : result_(result),
        tile_(result.report.atlas.width, result.report.atlas.height),
        width_(tile_.width * tileColumns(result.report.atlas)),
        height_(tile_.height * tileRows(result.report.atlas)),
        polygons_(atlasPolygons(mesh, result, Stacked::LeftOut)),
        edges_(atlasEdges(polygons_, result)) {}

  /// `colourOf` gives the colour of a face. Outlines are always drawn.
  Result<std::string> png(const std::function<Rgb(std::uint32_t)>& colourOf,
                          bool hasInnerEdges) const {
    const auto areas = byBand(polygons_.count(), 0, [&](std::uint32_t i) { return pointsOf(i); });
    const auto inner = linesByBand(hasInnerEdges, edges_.inner);
    const auto outline = linesByBand(true, edges_.outline);
    const float thinOpacity = innerOpacity();
    PngWriter out(static_cast<std::uint32_t>(width_), static_cast<std::uint32_t>(height_));
    for (std::size_t b = 0; b < areas.size(); ++b) {
      const int firstRow = static_cast<int>(b) * kBandRows;
      Band band(width_, firstRow, std::min(kBandRows, height_ - firstRow));
      for (const std::uint32_t i : areas[b]) band.fill(pointsOf(i), colourOf(polygons_.face[i]));
      for (const std::uint32_t e : inner[b]) draw(band, Band::Line::Thin, edges_.inner[e], kThin);
      for (const std::uint32_t e : outline[b])
        draw(band, Band::Line::Thick, edges_.outline[e], kThick);
      out.addRows(band.rgba(parseColour(kInk), thinOpacity, 1));
    }
    return out.finish();
  }

 private:
  using Edge = std::array<std::uint32_t, 2>;

  /// v points up, rows count down.
  Point at(std::uint32_t texcoord) const {
    const double* uv = &result_.uv[2 * static_cast<std::size_t>(texcoord)];
    return {uv[0] * tile_.width, height_ - uv[1] * tile_.height};
  }

  std::vector<Point> pointsOf(std::uint32_t polygon) const {
    std::vector<Point> out;
    for (std::uint32_t c = polygons_.offsets[polygon]; c < polygons_.offsets[polygon + 1]; ++c)
      out.push_back(at(result_.cornerUv[polygons_.corners[c]]));
    return out;
  }

  /// Indices of the shapes that reach into each band, with a margin in pixels.
  template <class Points>
  std::vector<std::vector<std::uint32_t>> byBand(std::size_t count, double margin,
                                                 const Points& points) const {
    const int bands = (height_ + kBandRows - 1) / kBandRows;
    const auto bandOf = [&](double y) {
      return static_cast<std::size_t>(std::clamp(std::floor(y / kBandRows), 0.0, bands - 1.0));
    };
    std::vector<std::vector<std::uint32_t>> out(static_cast<std::size_t>(bands));
    for (std::uint32_t i = 0; i < count; ++i) {
      double low = height_, high = 0;
      for (const Point& p : points(i)) {
        low = std::min(low, p.y);
        high = std::max(high, p.y);
      }
      for (std::size_t b = bandOf(low - margin); b <= bandOf(high + margin); ++b)
        out[b].push_back(i);
    }
    return out;
  }

  std::vector<std::vector<std::uint32_t>> linesByBand(bool isWanted,
                                                      const std::vector<Edge>& edges) const {
    return byBand(isWanted ? edges.size() : 0, kThick, [&](std::uint32_t e) {
      return std::array<Point, 2>{at(edges[e][0]), at(edges[e][1])};
    });
  }

  void draw(Band& band, Band::Line kind, const Edge& edge, double width) const {
    band.draw(kind, at(edge[0]), at(edge[1]), width);
  }

  /// Edges as dense as pixels would hide the colours.
  float innerOpacity() const {
    constexpr double kSparse = 12, kMost = 0.45, kLeast = 0.08;
    double sum = 0;
    for (const Edge& e : edges_.inner) {
      const Point a = at(e[0]), b = at(e[1]);
      sum += std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
    }
    const double mean = edges_.inner.empty() ? 0 : sum / static_cast<double>(edges_.inner.size());
    return static_cast<float>(std::max(kLeast, kMost * std::min(1.0, mean / kSparse)));
  }

  const UnwrapResult& result_;
  AtlasSize tile_;
  int width_, height_;
  AtlasPolygons polygons_;
  AtlasEdges edges_;
};

Status checkSize(const UnwrapResult& result) {
  const AtlasReport& atlas = result.report.atlas;
  // Both are at most 2^16 texels times 900 rows.
  if (std::max(atlas.width * tileColumns(atlas), atlas.height * tileRows(atlas)) <=
      kMostPictureTexels)
    return {};
  return {StatusCode::InvalidOption, "pictures have at most " + std::to_string(kMostPictureTexels) +
                                         " pixels along a side. Lower the resolution, or use "
                                         "SVG"};
}

Result<std::string> chartPng(const PolygonMesh& mesh, const UnwrapResult& result) {
  if (Status s = checkSize(result); !s.ok()) return s;
  return AtlasPainter(mesh, result)
      .png([&](std::uint32_t f) { return chartColour(result.chartOfFace[f]); }, true);
}

Result<std::string> ratioPng(const PolygonMesh& mesh, const UnwrapResult& result) {
  if (Status s = checkSize(result); !s.ok()) return s;
  const FaceAreas areas = faceAreas(mesh, result);
  const double scale = areas.uvSum > 0 ? areas.sum / areas.uvSum : 0;
  return AtlasPainter(mesh, result)
      .png(
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
