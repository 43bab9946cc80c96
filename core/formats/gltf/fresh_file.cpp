#include "gltf/fresh_file.h"

#include <algorithm>
#include <limits>

#include "abflat/version.h"
#include "gltf/container.h"
#include "gltf/edit.h"
#include "gltf/uri.h"
#include "gltf/used_extensions.h"

namespace abflat::gltf {
namespace {

constexpr int kUint16 = 5123, kUint32 = 5125, kFloat = 5126;

Json accessorOf(int componentType, std::size_t count, const char* type) {
  Json out;
  out["componentType"] = componentType;
  out["count"] = count;
  out["type"] = type;
  return out;
}

/// Appends to a list. Returns the index of the entry.
std::size_t added(Json& list, Json entry) {
  list.items().push_back(std::move(entry));
  return list.items().size() - 1;
}

Json named(const std::string& name) {
  Json out = Json::object();
  if (!name.empty()) out["name"] = name;
  return out;
}

}  // namespace

FreshFile::FreshFile() {
  json_["asset"]["generator"] = "abflat " ABFLAT_VERSION;
  json_["asset"]["version"] = "2.0";
  json_["scene"] = 0;
  json_["scenes"].items().emplace_back()["nodes"] = Json::array();
  json_["nodes"] = Json::array();
  json_["meshes"] = Json::array();
}

std::size_t FreshFile::addFloats(const std::vector<float>& values, const char* type,
                                 std::size_t components) {
  return addAccessor(values.data(), values.size() * sizeof(float),
                     static_cast<int>(Target::Vertices),
                     accessorOf(kFloat, values.size() / components, type));
}

std::size_t FreshFile::addColors(const std::vector<std::uint16_t>& rgba) {
  Json accessor;
  accessor["componentType"] = kUint16;
  accessor["normalized"] = true;
  accessor["count"] = rgba.size() / 4;
  accessor["type"] = "VEC4";
  return addAccessor(rgba.data(), rgba.size() * sizeof(std::uint16_t),
                     static_cast<int>(Target::Vertices), std::move(accessor));
}

std::size_t FreshFile::addPositions(const std::vector<float>& xyz) {
  Json least = Json::array(), most = Json::array();
  for (std::size_t d = 0; d < 3; ++d) {
    float lo = std::numeric_limits<float>::infinity(), hi = -lo;
    for (std::size_t i = d; i < xyz.size(); i += 3) {
      lo = std::min(lo, xyz[i]);
      hi = std::max(hi, xyz[i]);
    }
    least.items().emplace_back(lo);
    most.items().emplace_back(hi);
  }
  const std::size_t accessor = addFloats(xyz, "VEC3", 3);
  json_["accessors"][accessor]["min"] = std::move(least);
  json_["accessors"][accessor]["max"] = std::move(most);
  return accessor;
}

std::size_t FreshFile::addIndices(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
  Json accessor = accessorOf(kUint32, indices.size(), "SCALAR");
  constexpr int kTarget = static_cast<int>(Target::Indices);
  if (vertices > std::numeric_limits<std::uint16_t>::max())
    return addAccessor(indices.data(), indices.size() * sizeof(std::uint32_t), kTarget, accessor);
  const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
  accessor["componentType"] = kUint16;
  return addAccessor(narrow.data(), narrow.size() * sizeof(std::uint16_t), kTarget, accessor);
}

std::size_t FreshFile::addTexture(const std::string& name, const std::string& mimeType,
                                  const std::string& bytes) {
  Json image = named(name);
  image["mimeType"] = mimeType;
  image["bufferView"] = addView(bytes.data(), bytes.size());
  // Creating the second list may move the first, so it is looked up only then.
  const std::size_t source = added(json_["images"], std::move(image));
  Json texture;
  if (mimeType == "image/webp") {
    texture["extensions"][kTextureWebp]["source"] = source;
    for (const char* list : {"extensionsUsed", "extensionsRequired"})
      addOnce(json_[list], kTextureWebp);
  } else {
    texture["source"] = source;
  }
  return added(json_["textures"], std::move(texture));
}

std::size_t FreshFile::addMaterial(Json material) {
  return added(json_["materials"], std::move(material));
}

void FreshFile::addMesh(const std::string& name, const std::array<double, 3>& translation) {
  Json mesh = named(name), node = named(name);
  mesh["primitives"] = Json::array();
  node["mesh"] = added(json_["meshes"], std::move(mesh));
  const std::array<double, 3> none{};
  if (translation != none) node["translation"] = translation;
  json_["scenes"][0]["nodes"].items().push_back(added(json_["nodes"], std::move(node)));
}

void FreshFile::addPrimitive(Json primitive) {
  json_["meshes"].items().back()["primitives"].items().push_back(std::move(primitive));
}

Result<std::string> FreshFile::finish(bool isBinary) {
  json_["buffers"].items().emplace_back()["byteLength"] = buffer_.size();
  if (isBinary) return binaryFile(json_.dump(false), buffer_, {});
  json_["buffers"][0]["uri"] = dataUri(buffer_);
  return json_.dump(true) + "\n";
}

std::size_t FreshFile::addView(const void* bytes, std::size_t size) {
  buffer_.resize((buffer_.size() + 3) / 4 * 4);
  const std::size_t begin = buffer_.size();
  buffer_.append(static_cast<const char*>(bytes), size);
  Json view;
  view["buffer"] = 0;
  view["byteOffset"] = begin;
  view["byteLength"] = size;
  return added(json_["bufferViews"], std::move(view));
}

std::size_t FreshFile::addAccessor(const void* values, std::size_t size, int target,
                                   Json accessor) {
  accessor["bufferView"] = addView(values, size);
  json_["bufferViews"].items().back()["target"] = target;
  return added(json_["accessors"], std::move(accessor));
}

}  // namespace abflat::gltf
