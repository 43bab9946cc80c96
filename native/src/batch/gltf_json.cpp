#include "batch/gltf_json.h"

#include <algorithm>
#include <fstream>

namespace abflat::cli {

nlohmann::json gltfJson(const std::string& path) {
  constexpr std::size_t kHead = 20;
  std::ifstream in(path, std::ios::binary);
  std::string head(kHead, '\0');
  if (!in.read(head.data(), kHead)) return {};
  if (head.compare(0, 4, "glTF") != 0) {
    in.seekg(0);
    return nlohmann::json::parse(in, nullptr, false);
  }
  std::size_t length = 0;
  for (int i = 3; i >= 0; --i)
    length = length << 8 | static_cast<unsigned char>(head[12 + static_cast<std::size_t>(i)]);
  constexpr std::size_t kMost = std::size_t(1) << 28;
  std::string text(std::min(length, kMost), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  return nlohmann::json::parse(text, nullptr, false);
}

}  // namespace abflat::cli
