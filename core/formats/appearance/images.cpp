#include "appearance/images.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace abflat {
namespace {

/// For the image types that a glTF may hold; empty for others.
std::string mimeTypeOf(std::string_view bytes) {
  if (bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n") return "image/png";
  if (bytes.substr(0, 3) == "\xFF\xD8\xFF") return "image/jpeg";
  return {};
}

bool isAbsolute(const std::string& path) {
  return !path.empty() && (path[0] == '/' || (path.size() > 1 && path[1] == ':'));
}

}  // namespace

std::string folderOf(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

std::size_t Images::numberOf(const std::string& folder, std::string path) {
  std::replace(path.begin(), path.end(), '\\', '/');
  const std::string key = isAbsolute(path) ? path : folder + path;
  const auto known = numbers_.find(key);
  if (known != numbers_.end()) return known->second;
  return numbers_[key] = read(folder, path);
}

/// Looks where the image is said to be, then beside the file, since models are often moved together
/// with their images.
std::size_t Images::read(const std::string& folder, const std::string& path) {
  const std::string name = path.substr(folderOf(path).size());
  Result<std::string> bytes = readResource_(isAbsolute(path) ? path : folder + path);
  if (!bytes.ok() && name != path) {
    Result<std::string> beside = readResource_(folder + name);
    if (beside.ok()) bytes = std::move(beside);
  }
  if (!bytes.ok()) {
    notes_.push_back("image " + path + " was left out: " + bytes.status().message);
    return kNoImage;
  }
  ImageFile image{name, mimeTypeOf(bytes.value()), std::move(bytes.value())};
  if (image.mimeType.empty() && types_ == ImageTypes::OfGltf) {
    notes_.push_back("image " + path +
                     " was left out: glTF supports only PNG and JPEG. Convert it");
    return kNoImage;
  }
  out_.push_back(std::move(image));
  return out_.size() - 1;
}

}  // namespace abflat
