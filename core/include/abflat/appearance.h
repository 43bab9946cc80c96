#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "abflat/export.h"
#include "abflat/io.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

/// Returns the bytes of a file that another file refers to, given its path relative to that file.
/// The message of an error says why it cannot be read.
using ReadResource = std::function<Result<std::string>(const std::string& path)>;

/// Stands for "no image" where an image index is expected.
constexpr std::size_t kNoImage = static_cast<std::size_t>(-1);

/// In glTF's terms: colours are linear, factors from 0 to 1.
struct MaterialLook {
  std::array<double, 4> baseColor = {1, 1, 1, 1};
  std::array<double, 3> emission = {0, 0, 0};
  double metallic = 0, roughness = 1;
  std::size_t image = kNoImage;  ///< colour texture, sampled at the texcoords of the mesh
  std::size_t metallicRoughnessImage = kNoImage, normalImage = kNoImage, emissiveImage = kNoImage;
  double normalScale = 1;
  bool hasOpacityImage = false;  ///< the alpha of the colour texture counts
};

/// A file with an image.
struct ImageFile {
  std::string name, mimeType, bytes;
};

/// What a file says about the look of its mesh, beyond what is needed to unwrap it. A list is empty
/// if the file says nothing about it.
struct Appearance {
  std::vector<double> normals;             ///< xyz per normal, of length 1
  std::vector<std::uint32_t> faceNormals;  ///< normal of each face corner
  std::vector<double> colors;              ///< linear red, green, blue and alpha per vertex
  std::vector<std::uint32_t> faceObjects;  ///< per face, into objectNames
  std::vector<std::string> objectNames;
  std::vector<MaterialLook> materials;  ///< by number in faceMaterials; 0 also if none
  std::vector<ImageFile> images;
  std::vector<std::string> notes;  ///< what was not found, one sentence each
};

/// Appearance from the file that `mesh` was read from: an OBJ with its material files and their
/// images, or a PLY. Empty for other formats. Values that cannot be read are left out. Errors:
/// OutOfMemory.
ABFLAT_API Result<Appearance> readAppearance(std::string_view bytes, MeshFormat format,
                                             const PolygonMesh& mesh,
                                             const ReadResource& readResource);

}  // namespace abflat
