#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace abflat {

/// Compresses bytes to a zlib stream (RFC 1950 and 1951) with fixed codes: small code, and enough
/// for pictures of few colours.
class ZlibWriter {
 public:
  ZlibWriter() : out_("\x78\x01") {}
  /// Appends bytes, which are compressed by what they repeat of themselves.
  void add(const std::vector<std::uint8_t>& bytes);
  std::string finish();

 private:
  void putBits(std::uint32_t bits, int count);
  void putCode(std::uint32_t code, int length);
  void putLiteral(std::uint32_t symbol);
  void putMatch(std::uint32_t length, std::uint32_t distance);

  std::string out_;
  std::uint64_t pending_ = 0;
  int pendingCount_ = 0;
  std::uint32_t adlerA_ = 1, adlerB_ = 0;
};

}  // namespace abflat
