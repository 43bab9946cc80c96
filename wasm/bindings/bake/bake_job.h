#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "abflat/bake.h"
#include "abflat/progress.h"
#include "abflat/status.h"

namespace abflat::bindings {

/// Kinds of images, as BAKE_OPTIONS numbers them.
enum class ImageKind { Colour, Data, Normal };

/// One call of bake from JavaScript. v grows upwards, as everywhere in the package.
struct BakeJob {
  // The mesh, as it is drawn with the old textures.
  std::vector<double> positions;             ///< 3 per vertex
  std::vector<double> texcoords;             ///< 2 per vertex
  std::vector<float> colours;                ///< 4 per vertex; or empty
  std::vector<float> normals;                ///< 3 per vertex; or empty
  std::vector<float> tangents;               ///< 4 per vertex; or empty
  std::vector<std::uint32_t> indices;        ///< 3 per triangle
  std::vector<std::uint32_t> faceMaterials;  ///< per triangle; or empty: all have the first one
  std::vector<std::uint32_t> parts;          ///< per triangle; or empty: all are one part
  // The new layout of its triangles.
  std::vector<double> uv;                    ///< 2 per vertex of the layout
  std::vector<std::uint32_t> layoutIndices;  ///< 3 per triangle
  std::vector<std::uint32_t> vertexMap;      ///< of each vertex of the layout; or empty: the same

  std::deque<std::vector<std::uint8_t>> images;  ///< RGBA of 8 bits; they do not move
  std::vector<BakeTexture> textures;
  std::vector<BakeMaterial> materials;

  ImageKind kind = ImageKind::Colour;
  AtlasSize resolution;        ///< of the new image, as bakeSize() takes it
  AtlasSize layoutResolution;  ///< that the layout was packed for; 0 x 0: unknown
  int padding = 0;
  bool isOpaque = false;  ///< no texel is transparent, so those that nothing fills are not

  std::vector<std::uint8_t> pixels;  ///< RGBA of 8 bits
  AtlasSize size;
  std::string text;  ///< message of an error
};

/// Fills pixels and size. Errors: InvalidMesh, and those of bake.
Status bakeJob(BakeJob& job, const ProgressCallback& progress);

}  // namespace abflat::bindings
