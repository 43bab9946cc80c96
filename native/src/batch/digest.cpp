#include "batch/digest.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

namespace abflat::cli {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

Status unreadable(const std::string& path) {
  return {StatusCode::UnreadableFile, "cannot read " + path};
}

}  // namespace

void Digest::add(std::string_view bytes) {
  constexpr std::uint64_t kFactor = 0x13B, kHalf = 0xFFFFFFFF;  // the prime is 2^88 + kFactor
  for (const char byte : bytes) {
    low_ ^= static_cast<unsigned char>(byte);
    const std::uint64_t carried = ((low_ >> 32) * kFactor + ((low_ & kHalf) * kFactor >> 32)) >> 32;
    high_ = high_ * kFactor + carried + (low_ << 24);
    low_ *= kFactor;
  }
}

std::string Digest::text() const {
  std::string out;
  for (const std::uint64_t half : {high_, low_})
    for (int shift = 60; shift >= 0; shift -= 4) out += "0123456789abcdef"[half >> shift & 15];
  return out;
}

std::size_t Digest::partOf(std::size_t count) const {
  // The low bits of FNV are less mixed than the middle ones.
  return static_cast<std::size_t>((high_ ^ low_ ^ low_ >> 32) % count);
}

Result<Digest> fileDigest(const std::string& path) {
  std::error_code ignored;  // what cannot be looked up cannot be read
  if (!std::filesystem::is_regular_file(path, ignored)) return unreadable(path);
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) return unreadable(path);
  constexpr std::size_t kChunk = 1 << 18;
  std::vector<char> chunk(kChunk);
  Digest out;
  while (const std::size_t count = std::fread(chunk.data(), 1, kChunk, file.get()))
    out.add({chunk.data(), count});
  if (std::ferror(file.get()) != 0) return unreadable(path);
  return out;
}

}  // namespace abflat::cli
