#include <map>
#include <utility>

#include "abflat/gltf.h"
#include "base/guarded.h"
#include "gltf/baked_materials.h"
#include "gltf/container.h"
#include "gltf/drop_unused.h"
#include "gltf/edit.h"
#include "gltf/grow.h"
#include "gltf/source.h"
#include "gltf/split_parts.h"
#include "gltf/uri.h"

namespace abflat {
namespace gltf {
namespace {

std::string texcoordName(std::size_t set) { return "TEXCOORD_" + std::to_string(set); }

/// How often the primitives of a group refer to an accessor.
struct GroupUses {
  std::size_t asReplaced = 0;  ///< as the texcoords to be replaced
  std::size_t otherwise = 0;
};

class ModelWriter {
 public:
  ModelWriter(const Source& source, SplitParts split, std::size_t texcoord)
      : source_(source),
        document_(source.document),
        split_(std::move(split)),
        texcoord_(texcoord),
        usage_(document_),
        edit_(document_, usage_),
        partsOf_(source.groups.size()),
        uses_(source.groups.size()) {}

  std::pair<Json, std::string> write() {
    for (std::size_t p = 0; p < source_.parts.size(); ++p) {
      partsOf_[source_.parts[p].group].push_back(p);
      countUses(source_.parts[p]);
    }
    releaseAll();
    for (std::size_t g = 0; g < source_.groups.size(); ++g)
      if (source_.groups[g].vertexCount > 0) writeGroup(g);
    for (std::size_t p = 0; p < source_.parts.size(); ++p)
      if (split_.parts[p].needsIndices) writeIndices(p);
    return edit_.finish();
  }

 private:
  const Primitive& primitiveOf(const Part& part) const {
    return document_.meshes[part.mesh][part.primitive];
  }

  void countUses(const Part& part) {
    const Primitive& primitive = primitiveOf(part);
    std::map<std::size_t, GroupUses>& uses = uses_[part.group];
    for (const auto& [name, accessor] : primitive.attributes)
      ++(name == texcoordName(texcoord_) ? uses[accessor].asReplaced : uses[accessor].otherwise);
    for (const Attributes& target : primitive.targets)
      for (const auto& [name, accessor] : target) ++uses[accessor].otherwise;
  }

  /// Whether nothing beyond these uses refers to an accessor, so that the new content can take its
  /// index.
  bool isReplaced(std::size_t accessor, std::size_t uses) const {
    return uses > 0 && usage_.ofAccessor(accessor) == uses;
  }

  bool hasCopies(std::size_t group) const { return !split_.groups[group].copied.empty(); }

  void releaseAll() {
    for (std::size_t g = 0; g < uses_.size(); ++g)
      for (const auto& [accessor, uses] : uses_[g])
        if (isReplaced(accessor, uses.asReplaced) ||
            (hasCopies(g) && isReplaced(accessor, uses.otherwise)))
          edit_.release(accessor);
    for (std::size_t p = 0; p < source_.parts.size(); ++p) {
      const std::size_t indices = primitiveOf(source_.parts[p]).indices;
      if (split_.parts[p].needsIndices && indices != kNone && isReplaced(indices, 1))
        edit_.release(indices);
    }
  }

  void writeGroup(std::size_t g) {
    std::map<std::size_t, std::size_t> grown;  // new index of each accessor with copies
    if (hasCopies(g))
      for (const auto& [accessor, uses] : uses_[g])
        if (uses.otherwise > 0)
          grown[accessor] =
              edit_.putAccessor(isReplaced(accessor, uses.otherwise) ? accessor : kNone,
                                grownAccessor(document_, accessor, split_.groups[g].copied, edit_));
    const std::size_t texcoords = writeTexcoords(g);
    for (const std::size_t p : partsOf_[g]) {
      const Primitive& primitive = primitiveOf(source_.parts[p]);
      Json& json = jsonOf(p);
      refer(primitive.attributes, grown, json["attributes"]);
      for (std::size_t t = 0; t < primitive.targets.size(); ++t)
        refer(primitive.targets[t], grown, json["targets"][t]);
      for (std::size_t set = 0; set <= texcoord_; ++set)
        if (set == texcoord_ || accessorNamed(primitive.attributes, texcoordName(set)) == kNone)
          json["attributes"][texcoordName(set)] = texcoords;
    }
  }

  Json& jsonOf(std::size_t p) {
    const Part& part = source_.parts[p];
    return edit_.json()["meshes"][part.mesh]["primitives"][part.primitive];
  }

  static void refer(const Attributes& names, const std::map<std::size_t, std::size_t>& grown,
                    Json& json) {
    for (const auto& [name, accessor] : names) {
      const auto found = grown.find(accessor);
      if (found != grown.end()) json[name] = found->second;
    }
  }

  Json jsonOfAccessor(std::size_t slot) const {
    return slot == kNone ? Json::object() : document_.json["accessors"][slot];
  }

  std::size_t writeTexcoords(std::size_t g) {
    const Primitive& primitive = primitiveOf(source_.parts[partsOf_[g].front()]);
    std::size_t slot = accessorNamed(primitive.attributes, texcoordName(texcoord_));
    if (slot != kNone && !isReplaced(slot, uses_[g][slot].asReplaced)) slot = kNone;
    return edit_.putAccessor(slot,
                             texcoordAccessor(jsonOfAccessor(slot), split_.groups[g].uv, edit_));
  }

  void writeIndices(std::size_t p) {
    const std::size_t old = primitiveOf(source_.parts[p]).indices;
    const std::size_t slot = old != kNone && isReplaced(old, 1) ? old : kNone;
    const ComponentType type =
        old == kNone ? ComponentType::Uint16 : document_.accessors[old].shape.type;
    const std::size_t indices = edit_.putAccessor(
        slot, indexAccessor(jsonOfAccessor(slot), split_.parts[p].triangles, type, edit_));
    Json& json = jsonOf(p);
    json["indices"] = indices;
    if (json.has("mode")) json["mode"] = static_cast<int>(Mode::Triangles);
  }

  const Source& source_;
  const Document& document_;
  SplitParts split_;
  std::size_t texcoord_;
  Usage usage_;
  Edit edit_;
  std::vector<std::vector<std::size_t>> partsOf_;       ///< by group
  std::vector<std::map<std::size_t, GroupUses>> uses_;  ///< by group and accessor
};

/// Adjusts paths so that files beside the old file are found from the folder of the new one.
void moveImages(Json& json, const std::string& pathToSource) {
  Json* const images = json.find("images");
  if (!images || !images->isArray() || pathToSource.empty()) return;
  for (Json& image : images->items()) {
    Json* const uri = image.find("uri");
    if (!uri || !uri->text()) continue;
    const std::string old = *uri->text();
    const bool isBeside = !isDataUri(old) && !hasScheme(old) && old.substr(0, 1) != "/";
    if (isBeside) *uri = uriOfPath(pathToSource) + "/" + old;
  }
}

/// Whether a material has a normal map that uses a set of texcoords.
bool hasNormalMap(const Json& json, std::size_t material, std::size_t texcoord) {
  if (material == kNone) return false;
  const Json* const texture = json["materials"][material].find("normalTexture");
  if (!texture || !texture->isObject()) return false;
  const Json* const set = texture->find("texCoord");
  return set ? set->number() == static_cast<double>(texcoord) : texcoord == 0;
}

}  // namespace
}  // namespace gltf

Result<std::string> writeGltf(const gltf::Source& source, const std::vector<double>& uv,
                              const std::vector<std::uint32_t>& cornerUv,
                              const GltfWriteOptions& options) {
  return guarded([&]() -> Result<std::string> {
    gltf::SplitParts split = gltf::splitParts(source, uv, cornerUv, options.turnedFaces);
    auto [json, buffer] = gltf::ModelWriter(source, std::move(split), options.texcoord).write();
    if (options.baked) {
      gltf::putBaked(source, *options.baked, options.texcoord, json, buffer);
      if (gltf::knowsReferences(json)) gltf::dropUnused(json, buffer);
    }
    gltf::moveImages(json, options.pathToSource);
    if (options.isBinary)
      return gltf::binaryFile(json.dump(false), buffer, source.document.otherChunks);
    json["buffers"][0]["uri"] = gltf::dataUri(buffer);
    return json.dump(true) + "\n";
  });
}

std::string compressionNote(const gltf::Source& source) {
  const std::vector<std::string>& packings = source.document.packings;
  if (packings.empty()) return {};
  return source.document.fileName + " was compressed with " + packings.front() +
         (packings.size() > 1 ? " and " + packings[1] : "") + "; the output is uncompressed";
}

std::vector<std::string> staleNotes(const gltf::Source& source, std::size_t texcoord) {
  std::size_t count = 0;
  for (const gltf::Part& part : source.parts) {
    const gltf::Primitive& primitive = source.document.meshes[part.mesh][part.primitive];
    count += gltf::accessorNamed(primitive.attributes, "TANGENT") != gltf::kNone &&
             gltf::hasNormalMap(source.document.json, primitive.material, texcoord);
  }
  if (count == 0) return {};
  return {"the tangents of " + std::to_string(count) + (count == 1 ? " primitive" : " primitives") +
          " still match the old texcoords. Recompute them and rebake normal maps"};
}

}  // namespace abflat
