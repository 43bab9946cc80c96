#include "gltf/document.h"

#include <algorithm>

#include "gltf/container.h"
#include "gltf/read_json.h"
#include "gltf/uri.h"

namespace abflat::gltf {
namespace {

constexpr std::size_t kMostStride = 252;

std::size_t componentSize(ComponentType type) {
  switch (type) {
    case ComponentType::Int8:
    case ComponentType::Uint8:
      return 1;
    case ComponentType::Int16:
    case ComponentType::Uint16:
      return 2;
    case ComponentType::Uint32:
    case ComponentType::Float:
      return 4;
  }
  return 0;
}

/// Reads the lists one after the other; each refers to those before it.
class DocumentReader {
 public:
  DocumentReader(Document& out, const ReadResource& readResource)
      : out_(out), readResource_(readResource), complaints_(out.fileName) {}

  Status read(std::string_view ownBuffer, bool hasOwnBuffer) {
    const Field root(&out_.json, "", complaints_);
    readBuffers(root, ownBuffer, hasOwnBuffer);
    if (!resourceError_.ok()) return resourceError_;
    for (const std::string& buffer : out_.buffers) out_.size += buffer.size();
    for (const Field& view : root["bufferViews"].items()) out_.views.push_back(readView(view));
    for (const Field& a : root["accessors"].items()) out_.accessors.push_back(readAccessor(a));
    const std::size_t materials = root["materials"].items().size();
    for (const Field& mesh : root["meshes"].items()) {
      out_.meshes.emplace_back();
      for (const Field& primitive : mesh["primitives"].items())
        out_.meshes.back().push_back(readPrimitive(primitive, materials));
    }
    readScene(root);
    return complaints_.status();
  }

 private:
  /// Which buffers any view refers to. Others are not read: nothing of them would be used.
  static std::vector<bool> usedBuffers(const Field& root, std::size_t buffers) {
    std::vector<bool> out(buffers);
    for (const Field& view : root["bufferViews"].items()) {
      const std::size_t buffer = view["buffer"].requiredIndex(buffers, "buffers");
      if (buffer != kNone) out[buffer] = true;
    }
    return out;
  }

  void readBuffers(const Field& root, std::string_view ownBuffer, bool hasOwnBuffer) {
    const std::vector<Field> buffers = root["buffers"].items();
    const std::vector<bool> isUsed = usedBuffers(root, buffers.size());
    for (const Field& buffer : buffers) {
      if (!complaints_.none()) return;
      if (!isUsed[out_.buffers.size()]) {
        out_.buffers.emplace_back();
        continue;
      }
      const std::size_t length = buffer["byteLength"].count();
      const std::string uri = buffer["uri"].text();
      std::string bytes;
      const bool isFirst = out_.buffers.empty();
      if (!buffer["uri"].isPresent() && hasOwnBuffer && isFirst)
        bytes = std::string(ownBuffer);
      else if (!buffer["uri"].isPresent())
        buffer.complain("has no uri, and the file has no binary chunk for it");
      else
        bytes = resource(buffer["uri"], uri);
      if (!resourceError_.ok()) return;
      if (length > bytes.size())
        buffer.complain("declares " + std::to_string(length) + " bytes, but has only " +
                        std::to_string(bytes.size()) + ": it is truncated");
      bytes.resize(std::min(length, bytes.size()));
      out_.buffers.push_back(std::move(bytes));
    }
  }

  std::string resource(const Field& place, const std::string& uri) {
    if (isDataUri(uri)) {
      Result<std::string> data = dataOf(uri);
      if (!data.ok()) place.complain(data.status.message);
      return std::move(data.value);
    }
    if (hasScheme(uri)) {
      place.complain("is " + uri + ", which is not a local file. Download it first");
      return {};
    }
    Result<std::string> bytes = readResource_(pathOfUri(uri));
    if (!bytes.ok())
      resourceError_ = {bytes.status.code,
                        out_.fileName + ": " + place.place() + ": " + bytes.status.message};
    return std::move(bytes.value);
  }

  BufferView readView(const Field& view) const {
    BufferView out;
    out.buffer = view["buffer"].requiredIndex(out_.buffers.size(), "buffers");
    out.offset = view["byteOffset"].count(0);
    out.length = view["byteLength"].count();
    out.stride = view["byteStride"].count(0);
    if (out.stride > kMostStride) view["byteStride"].complain("exceeds 252");
    if (out.buffer == kNone) return out;
    const std::size_t size = out_.buffers[out.buffer].size();
    if (out.offset > size || out.length > size - out.offset)
      view.complain("ends at byte " + std::to_string(out.offset + out.length) + " of buffer " +
                    std::to_string(out.buffer) + ", which has " + std::to_string(size));
    return out;
  }

  ComponentType componentType(const Field& type) const {
    switch (type.count()) {
      case 5120:
        return ComponentType::Int8;
      case 5121:
        return ComponentType::Uint8;
      case 5122:
        return ComponentType::Int16;
      case 5123:
        return ComponentType::Uint16;
      case 5125:
        return ComponentType::Uint32;
      case 5126:
        return ComponentType::Float;
      default:
        type.complain("must be 5120, 5121, 5122, 5123, 5125 or 5126");
        return ComponentType::Float;
    }
  }

  ElementShape shape(const Field& accessor) const {
    const ComponentType type = componentType(accessor["componentType"]);
    const std::string name = accessor["type"].text();
    if (name == "SCALAR") return {type, 1, 1};
    const bool isVector = name.substr(0, 3) == "VEC", isMatrix = name.substr(0, 3) == "MAT";
    const bool isKnown = name.size() == 4 && name[3] >= '2' && name[3] <= '4';
    if (!isKnown || !(isVector || isMatrix)) {
      accessor["type"].complain("must be SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4");
      return {};
    }
    const std::size_t n = static_cast<std::size_t>(name[3] - '0');
    return {type, isMatrix ? n : 1, n};
  }

  /// That `count` elements of `size` bytes, every `stride` bytes, lie within a view.
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
    out.shape = shape(accessor);
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
  const ReadResource& readResource_;
  Complaints complaints_;
  Status resourceError_;
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

bool isUnsigned(ComponentType type) {
  return type == ComponentType::Uint8 || type == ComponentType::Uint16 ||
         type == ComponentType::Uint32;
}

std::size_t ElementShape::columnSize() const {
  constexpr std::size_t kAlignment = 4;
  const std::size_t size = rows * componentSize(type);
  return columns == 1 ? size : (size + kAlignment - 1) / kAlignment * kAlignment;
}

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
  if (!container.ok()) return container.status;
  Result<Json> json = readJson(container.value.json, fileName);
  if (!json.ok()) return json.status;
  Document out;
  out.fileName = fileName;
  out.isBinary = container.value.isBinary;
  out.json = std::move(json.value);
  out.otherChunks = container.value.others;
  out.size = bytes.size();
  const Status status =
      DocumentReader(out, readResource).read(container.value.buffer, container.value.hasBuffer);
  if (!status.ok()) return status;
  return out;
}

}  // namespace abflat::gltf
