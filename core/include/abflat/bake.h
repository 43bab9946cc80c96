#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "abflat/atlas_size.h"
#include "abflat/export.h"
#include "abflat/generated/bake_report.h"
#include "abflat/status.h"

// The old textures of a mesh follow its new layout: an image for new uv is made from images for old
// uv. All uv are those of glTF: u = 0, v = 0 is the outer corner of the first pixel of the first
// row, and v grows downwards. Where v grows upwards, as in OBJ, pass 1 - v.

namespace abflat {

/// How a texture goes on beyond its edges.
enum class Wrap { Repeat, Mirror, Clamp };

/// What the numbers in an image stand for. Alpha is always linear.
enum class ColourSpace { Srgb, Linear };

/// Pixels in the caller's memory, in rows from the top without gaps. It is only read.
struct ImageView {
  const void* pixels = nullptr;  ///< 16-bit ones aligned and in the byte order of the machine
  std::uint32_t width = 0, height = 0;
  int channels = 4;  ///< 1: grey; 2: grey, alpha; 3: red, green, blue; 4: all
  int bits = 8;      ///< of a channel, 8 or 16
};

struct BakeTexture {
  ImageView image;
  Wrap wrapU = Wrap::Repeat, wrapV = Wrap::Repeat;
  ColourSpace space = ColourSpace::Srgb;
  /// Colours count by their alpha when they are mixed, so that transparent ones do not bleed. False
  /// where alpha does not mean opacity, or is not used.
  bool alphaIsOpacity = true;
};

/// Stands for "no texture": white, or a flat normal.
constexpr std::uint32_t kNoTexture = 0xffffffffu;

/// A use of a texture. uv are scaled, then turned, then moved, as KHR_texture_transform does.
struct BakeMaterial {
  std::uint32_t texture = kNoTexture;
  std::array<double, 2> offset = {0, 0};
  double rotation = 0;  ///< in radians, counter-clockwise seen on the image
  std::array<double, 2> scale = {1, 1};
  /// The linear values of the texture are multiplied by this, and end at 1. Of a normal map, it is
  /// the vector: a normalScale of glTF is (s, s, 1).
  std::array<double, 4> factor = {1, 1, 1, 1};
};

/// Everything is listed corner by corner, three to a triangle.
struct BakeTriangles {
  std::vector<double> uv;                ///< 2 per corner, in the new layout
  std::vector<double> oldUv;             ///< 2 per corner
  std::vector<std::uint32_t> materials;  ///< per triangle
  std::vector<float> colours;            ///< 4 per corner, linear, to multiply by; or empty
  // For normal maps: xyz, and for tangents also the sign w. They are interpolated, not made unit
  // again, and the bitangent is w * cross(normal, tangent), as with MikkTSpace.
  std::vector<float> normals;      ///< 3 per corner
  std::vector<float> tangents;     ///< 4 per corner, in the new layout
  std::vector<float> oldTangents;  ///< 4 per corner

  std::size_t count() const { return uv.size() / 6; }
};

struct BakeInput {
  BakeTriangles triangles;
  std::vector<BakeMaterial> materials;
  std::vector<BakeTexture> textures;
};

enum class MapKind { Colour, Normal };

struct BakeOptions {
  MapKind kind = MapKind::Colour;
  std::uint32_t width = 0, height = 0;  ///< of the new image, each at most kMostBakedTexels
  int channels = 4;                     ///< as in ImageView; grey is the red channel
  int bits = 8;
  ColourSpace space = ColourSpace::Srgb;  ///< of the new image; a normal map is always linear
  /// Texels around those that a chart touches that take the colour of the nearest texel within.
  std::uint32_t padding = 4;
  bool fillsAll = false;  ///< all others do so too
  /// Of texels that nothing fills: red, green, blue and alpha, from 0 to 1, as they are encoded.
  std::array<double, 4> background = {0, 0, 0, 0};
  std::uint32_t bandRows = 64;  ///< the memory it takes grows with it; the image is the same
  int threads = 0;              ///< 0: one per processor; the image does not depend on it
};

constexpr std::uint32_t kMostBakedTexels = 1u << 15;

/// Takes some rows of an image, which follow those it took before; false ends the run.
using RowSink = std::function<bool(std::uint32_t firstRow, std::uint32_t rows,
                                   const std::vector<std::uint8_t>& bytes)>;

/// Makes one map for the new layout and passes its rows to `sink`, on the calling thread. 16-bit
/// numbers are in the byte order of the machine. Where triangles overlap, the first one wins. Those
/// without area in the new layout are left out. Errors: InvalidMesh, InvalidOption, Aborted.
ABFLAT_API Status bake(const BakeInput& input, const BakeOptions& options, const RowSink& sink);

/// The side of a square image (or of one with as many texels) that has as many texels to the
/// surface as the old textures have: the median over the new layout's area. 0 if no triangle with a
/// texture has area in both layouts.
ABFLAT_API double bakeResolution(const BakeInput& input);

/// The size of a new image, as abflat chooses it. A number in `wanted` is the longer side of an
/// image in the shape of `layout`, the resolution that the layout was packed for; 0 x 0 is unknown,
/// or a square. If `wanted` is 0 x 0, the longer side is the power of two that is nearest to
/// bakeResolution(); without a texture the size is that of the layout, or 1024. Sides that are not
/// asked for are at least 16 and at most 8192.
ABFLAT_API AtlasSize bakeSize(const BakeInput& input, const AtlasSize& wanted,
                              const AtlasSize& layout);

/// Padding in texels of the new image, where `padding` is in those of the layout, if it is known.
ABFLAT_API std::uint32_t bakePadding(int padding, const AtlasSize& image, const AtlasSize& layout);

/// The report of the program's bake as JSON.
ABFLAT_API std::string bakeReportJson(const BakeReport& report);

}  // namespace abflat
