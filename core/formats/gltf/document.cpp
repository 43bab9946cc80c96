#include "gltf/document.h"

#include <algorithm>

#include "gltf/boxes.h"
#include "gltf/container.h"
#include "gltf/decompress.h"
#include "gltf/read_json.h"

namespace abflat::gltf {
namespace {

/// Reads the lists one after another; each refers only to those before it.
class DocumentReader {
 public:
  DocumentReader(Document& out, Complaints& complaints) : out_(out), complaints_(complaints) {}

  void read() {
    const Field root(&out_.json, "", complaints_);
    for (const Field& view : root["bufferViews"].items())
      out_.views.push_back(readView(view, out_.buffers));
    for (const Field& a : root["accessors"].items()) out_.accessors.push_back(readAccessor(a));
    const std::size_t materials = root["materials"].items().size();
    for (const Field& mesh : root["meshes"].items()) {
      out_.meshes.emplace_back();
      for (const Field& primitive : mesh["primitives"].items())
        out_.meshes.back().push_back(readPrimitive(primitive, materials));
    }
    readScene(root);
  }

 private:
  /// Checks that `count` elements of `size` bytes, every `stride` bytes, lie within a view.
  void checkRange(const Field& place, std::size_t view, std::size_t offset, std::size_t count,
                  std::size_t size, std::size_t stride) const {
    if (view == kNone || count == 0) return;
    const std::size_t length = out_.views[view].length;
    if (stride < size)
      return place.complain("has elements of " + std::to_string(size) + " bytes, but bufferViews[" +
                            std::to_string(view) + "].byteStride is " + std::to_string(stride));
    if (offset > length || size > length - offset || (length - offset - size) / stride < count - 1)
      place.complain("has more elements than bufferViews[" + std::to_string(view) + "] holds");
  }

  Accessor readAccessor(const Field& accessor) const {
    Accessor out;
    const std::size_t views = out_.views.size();
    out.view = accessor["bufferView"].index(views, "bufferViews");
    out.offset = accessor["byteOffset"].count(0);
    out.count = accessor["count"].count();
    if (out.view == kNone && out.count > out_.size)
      accessor.complain("declares " + std::to_string(out.count) +
                        " elements without a bufferView, but the file has only " +
                        std::to_string(out_.size) + " bytes");
    out.shape = shapeOf(accessor);
    out.isNormalized = accessor["normalized"].flag();
    const std::size_t size = out.shape.size();
    if (out.view != kNone) {
      const std::size_t stride = out_.views[out.view].stride;
      checkRange(accessor, out.view, out.offset, out.count, size, stride == 0 ? size : stride);
    }
    const Field sparse = accessor["sparse"];
    if (!sparse.isPresent()) return out;
    SparseElements s;
    s.count = sparse["count"].count();
    if (s.count == 0) sparse["count"].complain("must not be 0");
    const Field indices = sparse["indices"], values = sparse["values"];
    s.indexView = indices["bufferView"].requiredIndex(views, "bufferViews");
    s.indexOffset = indices["byteOffset"].count(0);
    s.indexType = componentType(indices["componentType"]);
    if (!isUnsigned(s.indexType))
      indices["componentType"].complain("must be an unsigned integer type");
    s.valueView = values["bufferView"].requiredIndex(views, "bufferViews");
    s.valueOffset = values["byteOffset"].count(0);
    checkRange(indices, s.indexView, s.indexOffset, s.count, componentSize(s.indexType),
               componentSize(s.indexType));
    checkRange(values, s.valueView, s.valueOffset, s.count, size, size);
    out.sparse = s;
    return out;
  }

  Attributes readAttributes(const Field& attributes) const {
    Attributes out;
    for (const auto& [name, accessor] : attributes.members())
      out.emplace_back(name, accessor.requiredIndex(out_.accessors.size(), "accessors"));
    return out;
  }

  Primitive readPrimitive(const Field& primitive, std::size_t materials) const {
    Primitive out;
    constexpr std::size_t kModes = 7;
    const std::size_t mode = primitive["mode"].count(static_cast<std::size_t>(Mode::Triangles));
    if (mode < kModes)
      out.mode = static_cast<Mode>(mode);
    else
      primitive["mode"].complain("must not exceed 6");
    out.attributes = readAttributes(primitive["attributes"]);
    for (const Field& target : primitive["targets"].items())
      out.targets.push_back(readAttributes(target));
    out.indices = primitive["indices"].index(out_.accessors.size(), "accessors");
    out.material = primitive["material"].index(materials, "materials");
    return out;
  }

  void readScene(const Field& root) {
    const std::vector<Field> nodes = root["nodes"].items();
    const std::size_t skins = root["skins"].items().size();
    for (const Field& node : nodes) out_.nodes.push_back(readNode(node, nodes.size(), skins));
    const std::vector<Field> scenes = root["scenes"].items();
    const std::size_t chosen = root["scene"].index(scenes.size(), "scenes");
    if (scenes.empty()) return;
    out_.roots.emplace();
    for (const Field& node : scenes[chosen == kNone ? 0 : chosen]["nodes"].items())
      out_.roots->push_back(node.requiredIndex(nodes.size(), "nodes"));
  }

  Node readNode(const Field& node, std::size_t nodes, std::size_t skins) const;

  Document& out_;
  Complaints& complaints_;
};

/// Translation, rotation (a quaternion) and scale as a matrix.
Matrix composed(const double* t, const double* q, const double* s) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  return {(1 - 2 * (y * y + z * z)) * s[0],
          2 * (x * y + z * w) * s[0],
          2 * (x * z - y * w) * s[0],
          0,
          2 * (x * y - z * w) * s[1],
          (1 - 2 * (x * x + z * z)) * s[1],
          2 * (y * z + x * w) * s[1],
          0,
          2 * (x * z + y * w) * s[2],
          2 * (y * z - x * w) * s[2],
          (1 - 2 * (x * x + y * y)) * s[2],
          0,
          t[0],
          t[1],
          t[2],
          1};
}

Node DocumentReader::readNode(const Field& node, std::size_t nodes, std::size_t skins) const {
  Node out;
  for (const Field& child : node["children"].items())
    out.children.push_back(child.requiredIndex(nodes, "nodes"));
  out.mesh = node["mesh"].index(out_.meshes.size(), "meshes");
  out.skin = node["skin"].index(skins, "skins");
  if (node["matrix"].isPresent()) {
    node["matrix"].numbers(out.local.data(), out.local.size());
    return out;
  }
  double translation[3] = {0, 0, 0}, rotation[4] = {0, 0, 0, 1}, scale[3] = {1, 1, 1};
  node["translation"].numbers(translation, 3);
  node["rotation"].numbers(rotation, 4);
  node["scale"].numbers(scale, 3);
  out.local = composed(translation, rotation, scale);
  return out;
}

}  // namespace

std::size_t accessorNamed(const Attributes& attributes, const std::string& name) {
  for (const auto& [key, accessor] : attributes)
    if (key == name) return accessor;
  return kNone;
}

std::string primitivePlace(std::size_t mesh, std::size_t primitive) {
  return "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(primitive) + "]";
}

Result<Document> readDocument(std::string_view bytes, const std::string& fileName,
                              const ReadResource& readResource) {
  const Result<Container> container = openContainer(bytes, fileName);
  if (!container.ok()) return container.status();
  Result<Json> json = readJson(container.value().json, fileName);
  if (!json.ok()) return json.status();
  Document out;
  out.fileName = fileName;
  out.isBinary = container.value().isBinary;
  out.json = std::move(json.value());
  out.otherChunks = container.value().others;
  out.size = bytes.size();
  Complaints complaints(fileName);
  out.buffers = loadBuffers(Field(&out.json, "", complaints), container.value(), fileName,
                            readResource, complaints);
  for (const std::string& buffer : out.buffers) out.size += buffer.size();
  if (complaints.none()) decompress(out, complaints);
  if (complaints.none()) DocumentReader(out, complaints).read();
  if (complaints.none()) refreshBoxes(out, complaints);
  if (!complaints.none()) return complaints.status();
  return out;
}

}  // namespace abflat::gltf
