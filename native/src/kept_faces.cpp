#include "kept_faces.h"

#include <algorithm>
#include <sstream>

#include "rows_file.h"

namespace abflat::cli {
namespace {

/// What follows `key` at the beginning of a word, or nothing.
std::string valueOf(const std::string& word, const std::string& key) {
  return word.rfind(key, 0) == 0 ? word.substr(key.size()) : "";
}

bool hasTexcoords(const PolygonMesh& mesh, std::uint32_t face) {
  for (std::uint32_t c = mesh.faceOffsets[face]; c < mesh.faceOffsets[face + 1]; ++c)
    if (mesh.faceTexcoords[c] == kNoTexcoord) return false;
  return true;
}

}  // namespace

Result<KeptFaces> parseKept(const std::string& text) {
  KeptFaces out;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const std::string file = valueOf(word, "file=");
    if (word == "uv")
      out.hasUv = true;
    else if (!file.empty() && out.file.empty())
      out.file = file;
    else
      return Status{StatusCode::InvalidOption, "'" + word + "' is not uv or one file=PATH"};
  }
  if (!out.any()) return Status{StatusCode::InvalidOption, "name what to keep: uv or file=PATH"};
  return out;
}

Result<std::vector<std::uint32_t>> facesToKeep(const KeptFaces& kept, const PolygonMesh& mesh,
                                               const std::string& name) {
  std::vector<std::uint32_t> faces;
  if (!kept.file.empty()) {
    Result<std::vector<std::uint32_t>> listed =
        readRows<std::uint32_t>(kept.file, "a face number, such as '17'", readIndex);
    if (!listed.ok()) return listed;
    faces = std::move(listed.value);
  }
  if (kept.hasUv && mesh.faceTexcoords.empty())
    return Status{StatusCode::InvalidOption, name + ": the mesh has no texcoords to keep"};
  for (std::uint32_t f = 0; f < mesh.faceCount() && kept.hasUv; ++f)
    if (hasTexcoords(mesh, f)) faces.push_back(f);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace abflat::cli
