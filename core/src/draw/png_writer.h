#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/status.h"

namespace abflat {

/// A PNG file of 8 bits each for red, green, blue and alpha, row by row from the top. Rows are
/// compressed as they come.
class PngWriter {
 public:
  PngWriter(std::uint32_t width, std::uint32_t height);
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { deflateEnd(&stream_); }

  /// One or more rows, 4 bytes per pixel.
  void addRows(const std::vector<std::uint8_t>& rgba);
  /// Errors: OutOfMemory.
  Result<std::string> finish();

 private:
  void compress(std::vector<std::uint8_t> bytes, int flush);

  std::size_t rowBytes_;
  std::string header_;
  std::vector<std::uint8_t> above_;  ///< the row before
  z_stream stream_{};
  bool isReady_;
  std::string data_;  ///< compressed
};

}  // namespace abflat
