#include "files/kept_faces.h"

#include <algorithm>
#include <sstream>

#include "abflat/texcoord_faces.h"
#include "files/rows_file.h"

namespace abflat::cli {
namespace {

/// What follows `key` at the beginning of a word, or an empty string.
std::string valueOf(const std::string& word, const std::string& key) {
  return word.rfind(key, 0) == 0 ? word.substr(key.size()) : "";
}

std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names)
    if (!name.empty()) out += (out.empty() ? "'" : ", '") + name + "'";
  return out;
}

/// Adds the faces of all materials with this name.
Status addMaterial(const std::string& name, const PolygonMesh& mesh,
                   std::vector<std::uint32_t>& faces) {
  const std::vector<std::string>& names = mesh.materialNames;
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    const std::string known = listed(names);
    return {
        StatusCode::InvalidOption,
        "there is no material '" + name + "' to keep: " +
            (known.empty() ? "the materials of the mesh have no names" : "the mesh has " + known)};
  }
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    if (names[mesh.faceMaterials[f]] == name) faces.push_back(f);
  return {};
}

}  // namespace

Result<KeptFaces> parseKept(const std::string& text) {
  KeptFaces out;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const std::string file = valueOf(word, "file="), material = valueOf(word, "material=");
    if (word == "uv")
      out.hasUv = true;
    else if (!file.empty() && out.file.empty())
      out.file = file;
    else if (!material.empty())
      out.materials.push_back(material);
    else
      return Status{StatusCode::InvalidOption,
                    "'" + word + "' is not uv, material=NAME or one file=PATH"};
  }
  if (!out.any())
    return Status{StatusCode::InvalidOption, "nothing to keep. Use uv, material=NAME or file=PATH"};
  return out;
}

Result<std::vector<std::uint32_t>> facesToKeep(const KeptFaces& kept, const PolygonMesh& mesh,
                                               const std::string& name) {
  std::vector<std::uint32_t> faces;
  if (!kept.file.empty()) {
    Result<std::vector<std::uint32_t>> listed =
        readRows<std::uint32_t>(kept.file, "a face number, such as '17'", readIndex);
    if (!listed.ok()) return listed;
    faces = std::move(listed.value());
  }
  if (kept.hasUv || !kept.materials.empty()) {
    const Result<std::vector<std::uint32_t>> all = facesWithTexcoords(mesh);
    if (!all.ok()) return Status{all.status().code, name + ": " + all.status().message};
    if (kept.hasUv) faces.insert(faces.end(), all.value().begin(), all.value().end());
  }
  for (const std::string& material : kept.materials)
    if (Status s = addMaterial(material, mesh, faces); !s.ok())
      return Status{s.code, name + ": " + s.message};
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace abflat::cli
