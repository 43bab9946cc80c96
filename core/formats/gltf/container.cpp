#include "gltf/container.h"

#include <cstdint>
#include <cstring>
#include <limits>

namespace abflat::gltf {
namespace {

constexpr std::string_view kMagic = "glTF";
constexpr std::uint32_t kVersion = 2, kJsonChunk = 0x4E4F534A, kBufferChunk = 0x004E4942;
constexpr std::size_t kHeaderSize = 12, kChunkHeaderSize = 8, kChunkAlignment = 4;

/// Little endian.
std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  std::uint32_t out = 0;
  for (std::size_t i = 4; i-- > 0;) out = out << 8 | static_cast<unsigned char>(bytes[at + i]);
  return out;
}

void putWord(std::string& out, std::size_t value) {
  for (int i = 0; i < 4; ++i) out.push_back(static_cast<char>(value >> 8 * i & 0xff));
}

void putChunk(std::string& out, std::uint32_t type, std::string_view bytes, char filler) {
  const std::size_t padding = (kChunkAlignment - bytes.size() % kChunkAlignment) % kChunkAlignment;
  putWord(out, bytes.size() + padding);
  putWord(out, type);
  out.append(bytes);
  out.append(padding, filler);
}

Result<Container> openBinary(std::string_view bytes, const std::string& fileName) {
  const auto failure = [&](const std::string& sentence) {
    return Status{StatusCode::ParseError, fileName + ": " + sentence};
  };
  if (bytes.size() < kHeaderSize)
    return failure("this GLB is truncated: it ends within its 12-byte header");
  const std::uint32_t version = wordAt(bytes, 4), size = wordAt(bytes, 8);
  if (version != kVersion)
    return failure("glTF version " + std::to_string(version) +
                   " is not supported. Convert it to version 2");
  if (size > bytes.size())
    return failure("this GLB is truncated: its header declares " + std::to_string(size) +
                   " bytes, but it ends after " + std::to_string(bytes.size()));
  bytes = bytes.substr(0, size);
  Container out;
  out.isBinary = true;
  bool hasJson = false;
  for (std::size_t at = kHeaderSize; at < bytes.size();) {
    const std::string place = "the chunk at byte " + std::to_string(at);
    if (bytes.size() - at < kChunkHeaderSize) return failure(place + " has an incomplete header");
    const std::uint32_t length = wordAt(bytes, at), type = wordAt(bytes, at + 4);
    const std::size_t begin = at + kChunkHeaderSize;
    if (length > bytes.size() - begin)
      return failure(place + " declares " + std::to_string(length) + " bytes, but only " +
                     std::to_string(bytes.size() - begin) + " are left: this GLB is truncated");
    const std::string_view content = bytes.substr(begin, length);
    if (!hasJson && type != kJsonChunk)
      return failure(place + " is not JSON, but the first chunk must be");
    if (!hasJson) {
      out.json = content;
    } else if (type == kBufferChunk && !out.hasBuffer && out.others.empty()) {
      out.buffer = content;
      out.hasBuffer = true;
    } else {
      out.others = bytes.substr(at);
      break;
    }
    hasJson = true;
    at = begin + length;
  }
  if (!hasJson) return failure("the file has no JSON chunk");
  return out;
}

}  // namespace

bool looksLikeGltf(std::string_view bytes) {
  if (bytes.substr(0, kMagic.size()) == kMagic) return true;
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return begin != std::string_view::npos && bytes[begin] == '{';
}

Result<Container> openContainer(std::string_view bytes, const std::string& fileName) {
  if (bytes.substr(0, kMagic.size()) == kMagic) return openBinary(bytes, fileName);
  Container out;
  out.json = bytes;
  return out;
}

Result<std::string> binaryFile(std::string_view json, std::string_view buffer,
                               std::string_view others) {
  const std::size_t size = kHeaderSize + 2 * (kChunkHeaderSize + kChunkAlignment) + json.size() +
                           buffer.size() + others.size();
  if (size > std::numeric_limits<std::uint32_t>::max())
    return Status{StatusCode::CannotWrite,
                  "a .glb file cannot exceed 4 GB. Write .gltf, .obj or .ply instead"};
  std::string out;
  out.reserve(size);
  out.append(kMagic);
  putWord(out, kVersion);
  putWord(out, 0);
  putChunk(out, kJsonChunk, json, ' ');
  putChunk(out, kBufferChunk, buffer, '\0');
  out.append(others);
  std::string total;
  putWord(total, out.size());
  out.replace(8, 4, total);
  return out;
}

}  // namespace abflat::gltf
