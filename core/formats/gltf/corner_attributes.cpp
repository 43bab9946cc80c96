#include <algorithm>
#include <map>

#include "abflat/gltf.h"
#include "base/guarded.h"
#include "gltf/elements.h"
#include "gltf/source.h"

namespace abflat {
namespace gltf {
namespace {

/// What the mesh itself has, or what follows from texcoords.
bool isLeftOut(const std::string& name, const std::string& texcoord) {
  return name == "POSITION" || name == "NORMAL" || name == "TANGENT" || name == texcoord;
}

/// As in "1 face has other colors".
std::string wordsFor(const std::string& name) {
  if (name == "COLOR_0") return "colors";
  if (name.rfind("TEXCOORD_", 0) == 0) return "texcoords of set " + name.substr(9);
  return name + " values";
}

class AttributeReader {
 public:
  AttributeReader(const Source& source, std::size_t texcoord)
      : source_(source), texcoord_("TEXCOORD_" + std::to_string(texcoord)) {}

  std::vector<CornerAttribute> run() {
    for (const VertexGroup& group : source_.groups) {
      const Primitive& primitive = source_.document.meshes[group.mesh][group.primitive];
      for (const auto& [name, accessor] : primitive.attributes)
        if (!isLeftOut(name, texcoord_)) add(wordsFor(name), accessor, group);
      for (std::size_t t = 0; t < primitive.targets.size(); ++t)
        for (const auto& [name, accessor] : primitive.targets[t])
          add("morph target " + std::to_string(t) + " " + name + " values", accessor, group);
    }
    std::vector<CornerAttribute> out;
    for (auto& [name, found] : found_) out.push_back(finished(name, std::move(found)));
    return out;
  }

 private:
  struct Found {
    std::size_t width = 1;
    std::vector<double> values;  ///< row by row
    std::vector<std::uint32_t> rowOfVertex;
  };

  void add(const std::string& name, std::size_t index, const VertexGroup& group) {
    const Accessor& accessor = source_.document.accessors[index];
    Found& found = found_[name];
    if (found.values.empty()) {
      found.width = accessor.shape.components() * accessor.shape.columns;
      found.rowOfVertex.assign(source_.vertexCount, kNoRow);
    }
    const std::size_t width = accessor.shape.components() * accessor.shape.columns;
    const std::vector<double> values = numbersOf(source_.document, accessor);
    auto row = static_cast<std::uint32_t>(found.values.size() / found.width);
    for (std::uint32_t v = 0; v < group.vertexCount; ++v) {
      // Primitives may give colours with and without alpha, which is 1 then.
      for (std::size_t k = 0; k < found.width; ++k)
        found.values.push_back(k < width ? values[v * width + k] : 1);
      found.rowOfVertex[group.firstVertex + v] = row++;
    }
  }

  CornerAttribute finished(const std::string& name, Found&& found) const {
    CornerAttribute out;
    out.name = name;
    out.width = found.width;
    out.values = std::move(found.values);
    for (const std::uint32_t v : source_.faceVertices) out.row.push_back(found.rowOfVertex[v]);
    return out;
  }

  const Source& source_;
  const std::string texcoord_;
  std::map<std::string, Found> found_;
};

}  // namespace
}  // namespace gltf

std::vector<CornerAttribute> gltfAttributes(const gltf::Source& source, std::size_t texcoord) {
  return gltf::AttributeReader(source, texcoord).run();
}

}  // namespace abflat
