#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "abflat/gltf.h"
#include "base/guarded.h"
#include "gltf/corner_table.h"
#include "gltf/fresh_file.h"
#include "gltf/origin.h"
#include "mesh/triangulate.h"

namespace abflat {
namespace gltf {
namespace {

/// Faces of one object and material.
struct PrimitiveKey {
  std::uint32_t object = 0, material = 0;

  bool operator<(const PrimitiveKey& o) const {
    return std::pair(object, material) < std::pair(o.object, o.material);
  }
};

class ModelMaker {
 public:
  ModelMaker(const PolygonMesh& mesh, const std::vector<double>& uv,
             const std::vector<std::uint32_t>& cornerUv,
             const std::vector<std::uint32_t>& triangleCorners, const Appearance& look,
             const GltfMakeOptions& options)
      : mesh_(mesh),
        uv_(uv),
        cornerUv_(cornerUv),
        triangleCorners_(triangleCorners),
        look_(look),
        options_(options),
        offset_(originOf(mesh, triangleCorners).offset) {}

  Result<std::string> make() {
    findPrimitives();
    const std::vector<PrimitiveVertices> vertices =
        verticesOf(allCorners(), mesh_.vertexCount(), keys_.size());
    // Primitives of an object are together, in the order in which objects and materials appear.
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      if (i == 0 || keys_[i].object != keys_[i - 1].object)
        file_.addMesh(nameOf(keys_[i].object), offset_);
      addPrimitive(vertices[i], keys_[i].material);
    }
    return file_.finish(options_.isBinary);
  }

 private:
  void findPrimitives() {
    const auto keyOf = [&](std::size_t face) {
      return PrimitiveKey{look_.faceObjects.empty() ? 0 : look_.faceObjects[face],
                          mesh_.faceMaterials.empty() ? 0 : mesh_.faceMaterials[face]};
    };
    std::map<PrimitiveKey, std::uint32_t> numbers;
    for (std::size_t f = 0; f < mesh_.faceCount(); ++f) numbers.emplace(keyOf(f), 0);
    for (auto& [key, number] : numbers) {
      number = static_cast<std::uint32_t>(keys_.size());
      keys_.push_back(key);
    }
    for (std::size_t f = 0; f < mesh_.faceCount(); ++f)
      primitiveOfFace_.push_back(numbers[keyOf(f)]);
  }

  std::string nameOf(std::uint32_t object) const {
    return object < look_.objectNames.size() ? look_.objectNames[object] : std::string();
  }

  /// The mesh's own texcoords are useful beside the new ones, or if an image is painted on them.
  bool keepsOld(std::uint32_t material) const {
    const bool hasImage = !options_.isBaked && material < look_.materials.size() &&
                          look_.materials[material].image != kNoImage;
    return !mesh_.faceTexcoords.empty() && (options_.texcoord > 0 || hasImage);
  }

  /// Corners of all triangles, in the order of their faces.
  std::vector<Corner> allCorners() const {
    std::vector<Corner> out;
    out.reserve(triangleCorners_.size());
    std::size_t face = 0;
    for (const std::uint32_t corner : triangleCorners_) {
      while (mesh_.faceOffsets[face + 1] <= corner) ++face;
      out.push_back(cornerOf(corner, primitiveOfFace_[face]));
    }
    return out;
  }

  Corner cornerOf(std::uint32_t corner, std::uint32_t primitive) const {
    Corner out;
    out.vertex = mesh_.faceVertices[corner];
    out.primitive = primitive;
    if (!uv_.empty()) out.texcoord = cornerUv_[corner];
    if (keepsOld(keys_[primitive].material)) out.oldTexcoord = mesh_.faceTexcoords[corner];
    if (!look_.faceNormals.empty()) out.normal = look_.faceNormals[corner];
    return out;
  }

  void addPrimitive(const PrimitiveVertices& vertices, std::uint32_t material) {
    Json primitive;
    primitive["attributes"] = attributesOf(vertices.corners, keepsOld(material));
    primitive["indices"] = file_.addIndices(vertices.indices, vertices.corners.size());
    primitive["material"] = materialNumber(material);
    file_.addPrimitive(std::move(primitive));
  }

  /// Values of the corners, three each, less an offset.
  static std::vector<float> triples(const std::vector<double>& values,
                                    const std::vector<Corner>& corners,
                                    std::uint32_t Corner::*number,
                                    const std::array<double, 3>& offset = {}) {
    std::vector<float> out;
    out.reserve(3 * corners.size());
    for (const Corner& corner : corners)
      for (std::size_t d = 0; d < 3; ++d)
        out.push_back(static_cast<float>(values[3 * std::size_t{corner.*number} + d] - offset[d]));
    return out;
  }

  /// With v pointing down; 0 for a corner without texcoords.
  std::size_t addTexcoords(const std::vector<double>& uv, const std::vector<Corner>& corners,
                           std::uint32_t Corner::*number) {
    std::vector<float> out;
    out.reserve(2 * corners.size());
    for (const Corner& corner : corners) {
      const std::size_t at = 2 * std::size_t{corner.*number};
      const bool hasOne = corner.*number != kNoNumber;
      out.push_back(hasOne ? static_cast<float>(uv[at]) : 0);
      out.push_back(hasOne ? static_cast<float>(1 - uv[at + 1]) : 0);
    }
    return file_.addFloats(out, "VEC2", 2);
  }

  std::size_t addColors(const std::vector<Corner>& corners) {
    std::vector<std::uint16_t> out;
    out.reserve(4 * corners.size());
    for (const Corner& corner : corners)
      for (std::size_t d = 0; d < 4; ++d)
        out.push_back(static_cast<std::uint16_t>(
            std::lround(65535 * look_.colors[4 * std::size_t{corner.vertex} + d])));
    return file_.addColors(out);
  }

  Json attributesOf(const std::vector<Corner>& corners, bool hasOld) {
    Json out = Json::object();
    out["POSITION"] =
        file_.addPositions(triples(mesh_.positions, corners, &Corner::vertex, offset_));
    if (!look_.faceNormals.empty())
      out["NORMAL"] = file_.addFloats(triples(look_.normals, corners, &Corner::normal), "VEC3", 3);
    if (!look_.colors.empty()) out["COLOR_0"] = addColors(corners);
    if (uv_.empty()) return out;
    const std::size_t fresh = addTexcoords(uv_, corners, &Corner::texcoord);
    const std::size_t last = std::max(options_.texcoord, hasOld ? oldSet() : 0);
    for (std::size_t set = 0; set <= last; ++set)
      out["TEXCOORD_" + std::to_string(set)] =
          hasOld && set == oldSet() ? addTexcoords(mesh_.texcoords, corners, &Corner::oldTexcoord)
                                    : fresh;
    return out;
  }

  std::size_t oldSet() const { return options_.texcoord == 0 ? 1 : 0; }

  /// Index of a material of the mesh, which is added when first used.
  std::size_t materialNumber(std::uint32_t material) {
    const auto known = materials_.find(material);
    if (known != materials_.end()) return known->second;
    const MaterialLook look =
        material < look_.materials.size() ? look_.materials[material] : MaterialLook();
    Json json = Json::object();
    if (material < mesh_.materialNames.size() && !mesh_.materialNames[material].empty())
      json["name"] = mesh_.materialNames[material];
    Json& surface = json["pbrMetallicRoughness"];
    if (look.baseColor != MaterialLook().baseColor) surface["baseColorFactor"] = look.baseColor;
    const std::size_t set = imageSet(material);
    setTexture(surface, "baseColorTexture", look.image, set);
    setTexture(surface, "metallicRoughnessTexture", look.metallicRoughnessImage, set);
    surface["metallicFactor"] = look.metallic;
    if (look.roughness != 1) surface["roughnessFactor"] = look.roughness;
    // These may move what was looked up before.
    setTexture(json, "normalTexture", look.normalImage, set);
    if (look.normalImage != kNoImage && look.normalScale != 1)
      json["normalTexture"]["scale"] = look.normalScale;
    setTexture(json, "emissiveTexture", look.emissiveImage, set);
    if (look.emission != MaterialLook().emission) json["emissiveFactor"] = look.emission;
    if (look.baseColor[3] < 1 || look.hasOpacityImage) json["alphaMode"] = "BLEND";
    return materials_[material] = file_.addMaterial(std::move(json));
  }

  /// The set of texcoords that images of a material are for.
  std::size_t imageSet(std::uint32_t material) const {
    if (options_.isBaked) return options_.texcoord;
    return keepsOld(material) ? oldSet() : 0;
  }

  void setTexture(Json& object, const char* key, std::size_t image, std::size_t set) {
    if (image == kNoImage) return;
    object[key]["index"] = textureNumber(image);
    if (set > 0) object[key]["texCoord"] = set;
  }

  std::size_t textureNumber(std::size_t image) {
    const auto known = textures_.find(image);
    if (known != textures_.end()) return known->second;
    const ImageFile& file = look_.images[image];
    return textures_[image] = file_.addTexture(file.name, file.mimeType, file.bytes);
  }

  const PolygonMesh& mesh_;
  const std::vector<double>& uv_;
  const std::vector<std::uint32_t>& cornerUv_;
  const std::vector<std::uint32_t>& triangleCorners_;
  const Appearance& look_;
  const GltfMakeOptions& options_;
  const std::array<double, 3> offset_;  ///< of all nodes
  FreshFile file_;
  std::vector<PrimitiveKey> keys_;              ///< by primitive
  std::vector<std::uint32_t> primitiveOfFace_;  ///< by face of the mesh
  std::map<std::uint32_t, std::size_t> materials_;
  std::map<std::size_t, std::size_t> textures_;
};

/// Whether positions of all faces fit single precision, which is all that glTF offers.
Status checkRange(const PolygonMesh& mesh) {
  constexpr double kMost = std::numeric_limits<float>::max();
  for (const std::uint32_t v : mesh.faceVertices)
    for (std::size_t d = 0; d < 3; ++d)
      if (std::abs(mesh.positions[3 * std::size_t{v} + d]) > kMost)
        return {StatusCode::CannotWrite,
                "vertex " + std::to_string(v) +
                    " has a coordinate above 3.4e38, the largest number in glTF. Scale "
                    "the mesh or write OBJ instead"};
  return {};
}

}  // namespace
}  // namespace gltf

std::vector<std::uint32_t> triangleCornersOf(const PolygonMesh& mesh) {
  const auto corner = triangulate(mesh).corner;
  return {corner.begin(), corner.end()};
}

Result<std::string> makeGltf(const PolygonMesh& mesh, const std::vector<double>& uv,
                             const std::vector<std::uint32_t>& cornerUv,
                             const std::vector<std::uint32_t>& triangleCorners,
                             const Appearance& look, const GltfMakeOptions& options) {
  return guarded([&]() -> Result<std::string> {
    if (Status s = gltf::checkRange(mesh); !s.ok()) return s;
    return gltf::ModelMaker(mesh, uv, cornerUv, triangleCorners, look, options).make();
  });
}

}  // namespace abflat
