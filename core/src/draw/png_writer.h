#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "draw/zlib_writer.h"

namespace abflat {

/// A PNG file of 8 bits each for red, green, blue and alpha, row by row from the top.
class PngWriter {
 public:
  PngWriter(std::uint32_t width, std::uint32_t height);
  /// One or more rows, 4 bytes a pixel.
  void addRows(const std::vector<std::uint8_t>& rgba);
  std::string finish();

 private:
  std::size_t rowBytes_;
  std::string header_;
  std::vector<std::uint8_t> above_;  ///< the row before
  ZlibWriter data_;
};

}  // namespace abflat
