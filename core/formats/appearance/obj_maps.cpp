#include "abflat/obj_maps.h"

#include <map>
#include <set>

#include "appearance/images.h"
#include "appearance/mtl_libraries.h"
#include "appearance/mtl_map_line.h"
#include "base/guarded.h"
#include "base/number_text.h"
#include "io/obj_lines.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

/// Whether a line of an OBJ names material files; they are in `names` then.
bool isMtllib(const ObjLine& line, std::string& names) {
  if (line.kind != ObjLine::Kind::Other) return false;
  std::string_view words = line.text;
  if (takeWord(words) != "mtllib") return false;
  names = restOfLine(words);
  return true;
}

std::string_view withoutMark(std::string_view text) {
  return hasByteOrderMark(text) ? text.substr(kByteOrderMark.size()) : text;
}

std::vector<std::string> mtllibsOf(std::string_view obj) {
  std::vector<std::string> out;
  ObjLines lines(withoutMark(obj));
  ObjLine line;
  std::string names;
  while (lines.next(line))
    if (isMtllib(line, names)) out.push_back(names);
  return out;
}

/// Calls visit(material, file, line) for the lines of materials of the mesh, each where it counts.
template <class Visit>
void forEachLine(const ObjMaps& maps, const Visit& visit) {
  std::map<std::string_view, std::size_t> numbers;
  for (std::size_t m = 0; m < maps.materialNames.size(); ++m)
    numbers.emplace(maps.materialNames[m], m);
  constexpr auto kNone = static_cast<std::size_t>(-1);
  for (const MtlFile& file : maps.files) {
    std::size_t material = kNone;
    std::string_view text = withoutMark(file.text);
    while (!text.empty()) {
      const std::string_view line = text.substr(0, lineSize(text));
      text.remove_prefix(line.size());
      std::string_view words = line;
      if (takeWord(words) == "newmtl") {
        const auto known = numbers.find(restOfLine(words));
        material = known == numbers.end() ? kNone : known->second;
        if (known != numbers.end()) numbers.erase(known);
      }
      if (material != kNone) visit(material, file, line);
    }
  }
}

class MapReader {
 public:
  MapReader(const ReadResource& readResource, ObjMaps& out)
      : out_(out), images_(readResource, ImageTypes::All, out.images, out.notes) {}

  void run() {
    out_.materials.resize(out_.materialNames.size());
    forEachLine(out_, [&](std::size_t material, const MtlFile& file, std::string_view text) {
      MtlMapLine line;
      if (readMapLine(text, line)) add(material, file, line);
    });
  }

 private:
  void add(std::size_t material, const MtlFile& file, MtlMapLine& line) {
    if (line.map.meaning != MtlMeaning::Unknown)
      line.map.image = images_.numberOf(file.folder, line.path);
    else if (noted_.insert(line.map.name).second)
      out_.notes.push_back("'" + line.map.name + "' of material '" + out_.materialNames[material] +
                           "' was left out, because images of this kind are not baked");
    out_.materials[material].push_back(std::move(line.map));
  }

  ObjMaps& out_;
  Images images_;
  std::set<std::string> noted_;
};

}  // namespace

Result<ObjMaps> readObjMaps(std::string_view bytes, const PolygonMesh& mesh,
                            const ReadResource& readResource) {
  return guarded([&]() -> Result<ObjMaps> {
    ObjMaps out;
    out.materialNames = mesh.materialNames;
    MtlLibraries libraries(readResource, out.notes);
    libraries.addAll(mtllibsOf(bytes));
    out.files = libraries.takeFound();
    MapReader(readResource, out).run();
    return out;
  });
}

std::string writeMtl(const ObjMaps& maps, const std::vector<std::vector<std::string>>& names) {
  std::string out;
  std::vector<std::size_t> next(names.size());
  forEachLine(maps, [&](std::size_t material, const MtlFile&, std::string_view text) {
    const std::string_view end = lineEnd(text);
    MtlMapLine line;
    if (readMapLine(text, line)) {
      const std::string& name = names[material][next[material]++];
      if (name.empty()) return;
      out.append(line.keyword).append(" ").append(line.options).append(name);
    } else {
      out.append(text.substr(0, text.size() - end.size()));
    }
    out.append(end.empty() ? "\n" : end);
  });
  return out;
}

std::string withMtl(std::string_view obj, const std::string& name) {
  std::string out;
  out.reserve(obj.size() + name.size());
  ObjLines lines(obj);
  ObjLine line;
  std::string names;
  bool isNamed = false;
  while (lines.next(line)) {
    if (!isMtllib(line, names)) {
      out.append(line.text);
      continue;
    }
    if (!isNamed) out.append("mtllib ").append(name).append(lineEnd(line.text));
    isNamed = true;
  }
  return out;
}

}  // namespace abflat
