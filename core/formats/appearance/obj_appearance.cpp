#include <map>

#include "appearance/color.h"
#include "appearance/images.h"
#include "appearance/mtl.h"
#include "appearance/mtl_libraries.h"
#include "appearance/readers.h"
#include "base/number_text.h"
#include "io/obj_lines.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

/// Walks over a text that has already been read as a mesh, so its faces are well formed.
class ObjAppearanceReader {
 public:
  ObjAppearanceReader(const PolygonMesh& mesh, Appearance& out) : mesh_(mesh), out_(out) {}

  /// Appends the arguments of `mtllib` lines to `libraries`.
  void run(std::string_view text, std::vector<std::string>& libraries) {
    ObjLines lines(text);
    ObjLine line;
    while (lines.next(line)) {
      if (line.kind == ObjLine::Kind::Vertex) vertex(line);
      if (line.kind == ObjLine::Kind::Face) ++face_;
      if (line.kind == ObjLine::Kind::Other) other(line.text, libraries);
    }
    if (!out_.colors.empty()) out_.colors.resize(4 * mesh_.vertexCount(), 1);
    if (!out_.objectNames.empty()) out_.faceObjects.resize(mesh_.faceCount(), object_);
  }

 private:
  /// "x y z r g b"; with four numbers the last is a weight.
  void vertex(const ObjLine& line) {
    std::string_view words = argumentsOf(line, storage_);
    for (int d = 0; d < 3; ++d) takeWord(words);
    double color[4] = {0, 0, 0, 1};
    bool hasColor = true;
    for (int d = 0; d < 3 && hasColor; ++d) hasColor = parseDouble(takeWord(words), color[d]);
    if (hasColor && takeWord(words).empty()) {
      out_.colors.resize(4 * vertex_, 1);
      out_.colors.insert(out_.colors.end(), color, color + 4);
    }
    ++vertex_;
  }

  void other(std::string_view line, std::vector<std::string>& libraries) {
    const std::string_view keyword = takeWord(line);
    if (keyword == "o") object(restOfLine(line));
    if (keyword == "mtllib") libraries.emplace_back(restOfLine(line));
  }

  /// Faces before the first object have one of their own.
  void object(std::string_view name) {
    if (objects_.empty() && face_ > 0) addObject("");
    out_.faceObjects.resize(face_, object_);
    addObject(name);
  }

  void addObject(std::string_view name) {
    const auto number = static_cast<std::uint32_t>(objects_.size());
    const auto [known, isNew] = objects_.emplace(name, number);
    object_ = known->second;
    if (isNew) out_.objectNames.emplace_back(name);
  }

  const PolygonMesh& mesh_;
  Appearance& out_;
  std::size_t vertex_ = 0, face_ = 0;                          ///< indices of the next ones
  std::map<std::string, std::uint32_t, std::less<>> objects_;  ///< numbers by name
  std::uint32_t object_ = 0;                                   ///< of the faces to come
  std::string storage_;
};

MaterialLook lookOf(const MtlMaterial& mtl) {
  MaterialLook out;
  for (std::size_t d = 0; d < 3; ++d) {
    // An image replaces the colour: many programs write black or grey next to one.
    out.baseColor[d] = mtl.diffuseMap.empty() ? linearOfSrgb(mtl.diffuse[d]) : 1;
    out.emission[d] = linearOfSrgb(mtl.emission[d]);
  }
  out.baseColor[3] = mtl.opacity;
  out.metallic = mtl.metallic;
  out.roughness = mtl.roughness;
  return out;
}

/// The materials of a file, and the folder that their images are relative to.
struct Library {
  MtlMaterials materials;
  std::string folder;
};

/// The first library that has the material counts.
MaterialLook lookNamed(const std::string& name, const std::vector<Library>& libraries,
                       Images& images) {
  for (const Library& library : libraries) {
    const auto known = library.materials.find(name);
    if (known == library.materials.end()) continue;
    MaterialLook look = lookOf(known->second);
    const std::string& map = known->second.diffuseMap;
    if (!map.empty()) look.image = images.numberOf(library.folder, map);
    return look;
  }
  return {};
}

}  // namespace

void readObjAppearance(std::string_view bytes, const PolygonMesh& mesh,
                       const ReadResource& readResource, Appearance& out) {
  std::vector<std::string> lines;  // of mtllib
  ObjAppearanceReader(mesh, out).run(bytes, lines);
  MtlLibraries files(readResource, out.notes);
  files.addAll(lines);
  std::vector<Library> libraries;
  for (const MtlFile& file : files.takeFound()) {
    libraries.push_back({{}, file.folder});
    readMtl(file.text, libraries.back().materials);
  }
  if (libraries.empty()) return;
  Images images(readResource, ImageTypes::OfGltf, out.images, out.notes);
  for (const std::string& name : mesh.materialNames)
    out.materials.push_back(lookNamed(name, libraries, images));
}

}  // namespace abflat
