#include "gltf/read_json.h"

#include <algorithm>
#include <vector>

#include "gltf/field.h"

namespace abflat::gltf {
namespace {

/// Limit on nesting, because values are visited recursively later on.
constexpr std::size_t kMostLevels = 256;
/// Limit per object, because each key is compared with all before it.
constexpr std::size_t kMostKeys = 4096;

/// How deeply values are nested, measured before anything is built from them.
struct Nesting {
  std::size_t levels = 0, keys = 0;  ///< largest values found
};

Nesting nestingOf(std::string_view text) {
  Nesting most;
  std::vector<std::size_t> colons;  // of each enclosing value; only objects have any
  bool isInString = false;
  for (std::size_t i = 0; i < text.size() && most.levels <= kMostLevels; ++i) {
    const char c = text[i];
    if (isInString) {
      if (c == '\\') ++i;
      isInString = c != '"';
    } else if (c == '"') {
      isInString = true;
    } else if (c == '{' || c == '[') {
      colons.push_back(0);
      most.levels = std::max(most.levels, colons.size());
    } else if ((c == '}' || c == ']') && !colons.empty()) {
      colons.pop_back();
    } else if (c == ':' && !colons.empty()) {
      most.keys = std::max(most.keys, ++colons.back());
    }
  }
  return most;
}

void checkVersion(const Field& root, Complaints& complaints) {
  const Field asset = root["asset"];
  if (!asset.isPresent()) return complaints.add("this is not a glTF file: its JSON has no 'asset'");
  const std::string version = asset["version"].text();
  if (version.substr(0, 2) != "2.")
    complaints.add("glTF version '" + version + "' is not supported. Convert it to version 2.0");
}

}  // namespace

Result<Json> readJson(std::string_view text, const std::string& fileName) {
  Complaints complaints(fileName);
  if (text.empty()) complaints.add("the file is empty");
  const Nesting nesting = nestingOf(text);
  if (nesting.levels > kMostLevels)
    complaints.add("the JSON is nested more than " + std::to_string(kMostLevels) + " levels deep");
  if (nesting.keys > kMostKeys)
    complaints.add("the JSON has an object of more than " + std::to_string(kMostKeys) + " entries");
  if (!complaints.none()) return complaints.status();
  std::optional<Json> json = parsedJson(text);
  if (!json) {
    complaints.add("the JSON is not valid. Is the file truncated?");
    return complaints.status();
  }
  const Field root(&*json, "", complaints);
  checkVersion(root, complaints);
  if (!complaints.none()) return complaints.status();
  return std::move(*json);
}

}  // namespace abflat::gltf
