#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "abflat/status.h"

namespace abflat::cli {

/// FNV-1a with 128 bits: tells contents apart, but is no protection against someone who makes two
/// with the same digest.
class Digest {
 public:
  void add(std::string_view bytes);
  /// 32 hexadecimal digits.
  std::string text() const;
  /// The digest as a part of `count` parts, from 0.
  std::size_t partOf(std::size_t count) const;

 private:
  std::uint64_t high_ = 0x6c62272e07bb0142, low_ = 0x62b821756295c58d;
};

/// Of all bytes of an ordinary file. Errors: UnreadableFile.
Result<Digest> fileDigest(const std::string& path);

}  // namespace abflat::cli
