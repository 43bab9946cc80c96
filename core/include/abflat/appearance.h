#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "abflat/io.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

/// Bytes of a file that another one refers to, by its path relative to that one.
/// The message of an error says why it cannot be read.
using ReadResource = std::function<Result<std::string>(const std::string& path)>;

/// In place of a number of an image.
constexpr std::size_t kNoImage = static_cast<std::size_t>(-1);

/// As a glTF takes it: colours are linear, factors from 0 to 1.
struct MaterialLook {
  std::array<double, 4> baseColor = {1, 1, 1, 1};
  std::array<double, 3> emission = {0, 0, 0};
  double metallic = 0, roughness = 1;
  std::size_t image = kNoImage;  ///< of its colours, at the texcoords of the mesh
};

/// A PNG or JPEG file.
struct ImageFile {
  std::string name, mimeType, bytes;
};

/// What a file says about how its mesh looks, beyond what is needed to unwrap it. Each list is
/// empty where it says nothing.
struct Appearance {
  std::vector<double> normals;             ///< xyz per normal, of length 1
  std::vector<std::uint32_t> faceNormals;  ///< normal of each face corner
  std::vector<double> colors;              ///< linear red, green, blue and alpha per vertex
  std::vector<std::uint32_t> faceObjects;  ///< per face, into objectNames
  std::vector<std::string> objectNames;
  std::vector<MaterialLook> materials;  ///< by number in faceMaterials; number 0 is also that of a
                                        ///< mesh without materials
  std::vector<ImageFile> images;
  std::vector<std::string> notes;  ///< what was not found, one sentence each
};

/// Of the file that `mesh` was read from: an OBJ with its material files and their images, or a
/// PLY; nothing of others. Values that cannot be read are none.
Appearance readAppearance(std::string_view bytes, MeshFormat format, const PolygonMesh& mesh,
                          const ReadResource& readResource);

}  // namespace abflat
