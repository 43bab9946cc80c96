#include "batch/mesh_digest.h"

#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "batch/gltf_json.h"
#include "files/paths.h"

namespace abflat::cli {
namespace {

/// "a%20b" is "a b".
std::string withoutPercents(const std::string& uri) {
  const auto digit = [&](std::size_t i) {
    const std::string_view digits = "0123456789abcdef";
    return i < uri.size() ? digits.find(static_cast<char>(uri[i] | 0x20)) : std::string::npos;
  };
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const std::size_t high = uri[i] == '%' ? digit(i + 1) : std::string::npos;
    const std::size_t low = uri[i] == '%' ? digit(i + 2) : std::string::npos;
    const bool isCode = high != std::string::npos && low != std::string::npos;
    out += isCode ? static_cast<char>(high * 16 + low) : uri[i];
    if (isCode) i += 2;
  }
  return out;
}

/// Files that a glTF names.
std::vector<std::string> gltfFiles(const std::string& path) {
  std::vector<std::string> out;
  const nlohmann::json gltf = gltfJson(path);
  if (!gltf.is_object()) return out;
  for (const char* list : {"buffers", "images"}) {
    if (!gltf.contains(list) || !gltf[list].is_array()) continue;
    for (const nlohmann::json& each : gltf[list])
      if (each.is_object() && each.contains("uri") && each["uri"].is_string())
        out.push_back(withoutPercents(each["uri"].get<std::string>()));
  }
  return out;
}

/// Material files that an OBJ names, which is done before its faces.
std::vector<std::string> objFiles(const std::string& path) {
  constexpr std::string_view kWord = "mtllib ";
  std::vector<std::string> out;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line) && line.compare(0, 2, "f ") != 0;) {
    if (line.compare(0, kWord.size(), kWord) != 0) continue;
    const std::size_t last = line.find_last_not_of(" \t\r");
    out.push_back(line.substr(kWord.size(), last + 1 - kWord.size()));
  }
  return out;
}

std::vector<std::string> filesNamedBy(const std::string& path) {
  const std::string ending = endingOf(path);
  if (ending == ".gltf" || ending == ".glb") return gltfFiles(path);
  return ending == ".obj" ? objFiles(path) : std::vector<std::string>();
}

}  // namespace

Result<Digest> meshDigest(const std::string& path) {
  Result<Digest> out = fileDigest(path);
  if (!out.ok()) return out;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (const std::string& name : filesNamedBy(path)) {
    const std::filesystem::path file = folder / name.c_str();  // up to a zero byte
    // One that is missing, or within a data URI, has no content of its own.
    if (const Result<Digest> digest = fileDigest(file.string()); digest.ok())
      out.value().add(digest.value().text());
  }
  return out;
}

Result<Digest> atlasDigest(const std::vector<BatchInput>& meshes) {
  Digest out;
  for (const BatchInput& mesh : meshes) {
    const Result<Digest> content = meshDigest(mesh.path);
    if (!content.ok()) return content.status();
    out.add(mesh.name + "\n" + content.value().text() + "\n");
  }
  return out;
}

}  // namespace abflat::cli
