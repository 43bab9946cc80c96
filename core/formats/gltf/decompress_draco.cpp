#include "gltf/decompress_draco.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "gltf/draco_extension.h"
#include "gltf/draco_mesh.h"
#include "gltf/json_extensions.h"
#include "gltf/packed_indices.h"
#include "gltf/target.h"

namespace abflat::gltf {
namespace {

struct PackedAttribute {
  std::string name;
  std::size_t accessor = kNone;
  std::uint32_t id = 0;  ///< Draco's
};

struct PackedPrimitive {
  std::size_t mesh = 0, primitive = 0, view = kNone, indices = kNone;
  std::string place;  ///< path of the extension in the document
  std::vector<PackedAttribute> attributes;
  bool hasPlainCopy = true;  ///< whether its accessors have bytes of their own
};

/// Part of a compressed mesh: an attribute, or the triangles.
struct Content {
  std::size_t view = kNone, id = kNone;

  bool operator<(const Content& other) const {
    return std::pair(view, id) < std::pair(other.view, other.id);
  }
};

PackedPrimitive packedPrimitive(const Field& primitive, const Field& accessors, std::size_t views) {
  const Field extension = primitive["extensions"][kDracoExtension];
  const std::vector<Field> all = accessors.items();
  PackedPrimitive out;
  out.place = extension.place();
  out.view = extension["bufferView"].requiredIndex(views, "bufferViews");
  constexpr std::size_t kTriangles = 4, kStrip = 5;
  const std::size_t mode = primitive["mode"].count(kTriangles);
  if (mode != kTriangles && mode != kStrip)
    extension.complain("is for triangles, but the mode of its primitive is " +
                       std::to_string(mode) + ". Save the file without compression");
  out.indices = primitive["indices"].index(all.size(), "accessors");
  if (out.indices != kNone) out.hasPlainCopy = all[out.indices]["bufferView"].isPresent();
  for (const auto& [name, id] : extension["attributes"].members()) {
    const std::size_t accessor =
        primitive["attributes"][name].requiredIndex(all.size(), "accessors");
    const std::size_t number = id.index(std::numeric_limits<std::uint32_t>::max(), "attributes");
    if (accessor == kNone || number == kNone) return out;
    out.attributes.push_back({name, accessor, static_cast<std::uint32_t>(number)});
    out.hasPlainCopy = out.hasPlainCopy && all[accessor]["bufferView"].isPresent();
  }
  return out;
}

class PrimitiveDecoder {
 public:
  PrimitiveDecoder(Document& document, DecodedViews& views, Complaints& complaints)
      : document_(document), views_(views), complaints_(complaints) {}

  bool decodeAll() {
    const std::map<std::size_t, std::vector<PackedPrimitive>> byView = collect();
    for (const auto& [view, primitives] : byView)
      if (complaints_.none()) decodeView(view, primitives);
    return !byView.empty();
  }

 private:
  /// Compressed meshes and the primitives that share them, so that each is decoded once.
  std::map<std::size_t, std::vector<PackedPrimitive>> collect() const {
    std::map<std::size_t, std::vector<PackedPrimitive>> out;
    const Field root(&document_.json, "", complaints_);
    const std::size_t views = root["bufferViews"].items().size();
    const std::vector<Field> meshes = root["meshes"].items();
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const std::vector<Field> primitives = meshes[m]["primitives"].items();
      for (std::size_t p = 0; p < primitives.size(); ++p) {
        if (!primitives[p]["extensions"][kDracoExtension].isPresent()) continue;
        PackedPrimitive packed = packedPrimitive(primitives[p], root["accessors"], views);
        packed.mesh = m;
        packed.primitive = p;
        out[packed.view].push_back(std::move(packed));
      }
    }
    return out;
  }

  void decodeView(std::size_t view, const std::vector<PackedPrimitive>& primitives) {
    const std::string& place = primitives.front().place;
    const Field field(&document_.json["bufferViews"][view],
                      "bufferViews[" + std::to_string(view) + "]", complaints_);
    const BufferView source = readView(field, document_.buffers);
    if (!complaints_.none()) return;
    freeView_ = view;
    for (const char* key : {"byteStride", "target"}) document_.json["bufferViews"][view].erase(key);
    const bool isNeeded = std::any_of(primitives.begin(), primitives.end(),
                                      [](const PackedPrimitive& p) { return !p.hasPlainCopy; });
    if (isNeeded) {
      const Result<DracoMesh> mesh =
          DracoMesh::decode(bytesOf(source, document_.buffers), views_.budget());
      if (!mesh.ok()) return complaints_.add(place + mesh.status().message);
      for (const PackedPrimitive& packed : primitives)
        if (!packed.hasPlainCopy && complaints_.none()) putPrimitive(packed, mesh.value());
    }
    // Views keep their indices: if nothing new takes this one's place, it becomes as short as
    // possible.
    if (freeView_ != kNone) views_.put(freeView_, std::string(1, '\0'));
    for (const PackedPrimitive& packed : primitives)
      removeExtension(jsonOf(packed), kDracoExtension);
  }

  Json& jsonOf(const PackedPrimitive& packed) {
    return document_.json["meshes"][packed.mesh]["primitives"][packed.primitive];
  }

  void putPrimitive(const PackedPrimitive& packed, const DracoMesh& mesh) {
    Json& json = jsonOf(packed);
    json["indices"] = putIndices(packed, mesh);
    if (json.has("mode")) json["mode"] = static_cast<int>(Mode::Triangles);
    for (const PackedAttribute& attribute : packed.attributes)
      if (complaints_.none())
        json["attributes"][attribute.name] = putAttribute(packed, attribute, mesh);
  }

  std::size_t putIndices(const PackedPrimitive& packed, const DracoMesh& mesh) {
    const auto [slot, isNew] = slotFor(packed.indices, {packed.view, kNone});
    if (!isNew) return slot;
    Json& json = accessor(slot);
    if (packed.indices == kNone) json["componentType"] = typeCode(ComponentType::Uint16);
    const std::vector<std::uint32_t> indices = mesh.indices();
    const ComponentType given = componentType(fieldOf(slot)["componentType"]);
    const ComponentType type = typeFor(isUnsigned(given) ? given : ComponentType::Uint16,
                                       *std::max_element(indices.begin(), indices.end()));
    json["componentType"] = typeCode(type);
    json["type"] = "SCALAR";
    if (!take(packed, indices.size() * componentSize(type))) return slot;
    refer(slot, indices.size(), putView(abflat::gltf::packed(indices, type), Target::Indices, 0));
    return slot;
  }

  std::size_t putAttribute(const PackedPrimitive& packed, const PackedAttribute& attribute,
                           const DracoMesh& mesh) {
    const auto [slot, isNew] = slotFor(attribute.accessor, {packed.view, attribute.id});
    if (!isNew) return slot;
    const ElementShape shape = shapeOf(fieldOf(slot));
    if (!complaints_.none() || !take(packed, mesh.points() * shape.size())) return slot;
    if (shape.columns != 1) {
      complaints_.add(packed.place + ".attributes." + attribute.name +
                      " holds matrices, which Draco does not support");
      return slot;
    }
    Result<std::string> values = mesh.attribute(attribute.id, shape.type, shape.rows);
    if (!values.ok()) {
      complaints_.add(packed.place + ".attributes." + attribute.name + values.status().message);
      return slot;
    }
    const std::size_t stride = values.value().size() / std::max<std::size_t>(mesh.points(), 1);
    refer(
        slot, mesh.points(),
        putView(std::move(values.value()), Target::Vertices, stride == shape.size() ? 0 : stride));
    return slot;
  }

  bool take(const PackedPrimitive& packed, std::size_t bytes) {
    if (views_.budget().take(bytes)) return true;
    complaints_.add(packed.place + " decodes to far more than the size of the file allows");
    return false;
  }

  /// The accessor for a content, and whether it still has to be filled. An accessor that already
  /// has another content is copied.
  std::pair<std::size_t, bool> slotFor(std::size_t accessor, const Content& content) {
    const auto [known, isNew] = slots_.emplace(std::pair(accessor, content), accessor);
    if (!isNew) return {known->second, false};
    if (accessor == kNone || !taken_.insert(accessor).second) {
      Json::Items& accessors = document_.json["accessors"].items();
      known->second = accessors.size();
      Json copy = accessor == kNone ? Json::object() : accessors[accessor];
      accessors.push_back(std::move(copy));
    }
    return {known->second, true};
  }

  Json& accessor(std::size_t slot) { return document_.json["accessors"][slot]; }

  Field fieldOf(std::size_t slot) {
    return {&accessor(slot), "accessors[" + std::to_string(slot) + "]", complaints_};
  }

  std::size_t putView(std::string bytes, Target target, std::size_t stride) {
    const std::size_t view = views_.put(std::exchange(freeView_, kNone), std::move(bytes));
    Json& json = document_.json["bufferViews"][view];
    if (stride != 0) json["byteStride"] = stride;
    json["target"] = static_cast<int>(target);
    return view;
  }

  void refer(std::size_t slot, std::size_t count, std::size_t view) {
    Json& json = accessor(slot);
    json.erase("byteOffset");
    json["bufferView"] = view;
    json["count"] = count;
  }

  Document& document_;
  DecodedViews& views_;
  Complaints& complaints_;
  std::size_t freeView_ = kNone;  ///< the view of the compressed mesh, until it is reused
  std::map<std::pair<std::size_t, Content>, std::size_t> slots_;
  std::set<std::size_t> taken_;
};

}  // namespace

bool decompressPrimitives(Document& document, DecodedViews& views, Complaints& complaints) {
  return PrimitiveDecoder(document, views, complaints).decodeAll();
}

}  // namespace abflat::gltf
