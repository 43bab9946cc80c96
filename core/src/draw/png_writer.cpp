#include "draw/png_writer.h"

#include <array>
#include <cstdlib>
#include <string_view>

namespace abflat {
namespace {

void put32(std::string& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 0xff);
}

/// The CRC-32 of PNG and zip.
std::uint32_t crcOf(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      table[n] = n;
      for (int k = 0; k < 8; ++k)
        table[n] = (table[n] & 1) ? 0xedb88320u ^ table[n] >> 1 : table[n] >> 1;
    }
    return table;
  }();
  std::uint32_t crc = 0xffffffffu;
  for (const char c : bytes) crc = kTable[(crc ^ static_cast<std::uint8_t>(c)) & 0xff] ^ crc >> 8;
  return ~crc;
}

std::string chunk(std::string_view type, std::string_view data) {
  std::string out;
  put32(out, static_cast<std::uint32_t>(data.size()));
  out += type;
  out += data;
  put32(out, crcOf(std::string_view(out).substr(4)));
  return out;
}

/// Differences to the pixel on the left (1) or above (2), whichever are smaller.
void appendFiltered(const std::uint8_t* row, const std::vector<std::uint8_t>& above,
                    std::vector<std::uint8_t>& out) {
  const std::size_t n = above.size();
  const auto left = [&](std::size_t i) {
    return static_cast<std::uint8_t>(i < 4 ? 0 : row[i - 4]);
  };
  const auto size = [](int difference) { return std::abs(static_cast<std::int8_t>(difference)); };
  std::size_t sumLeft = 0, sumAbove = 0;
  for (std::size_t i = 0; i < n; ++i) {
    sumLeft += static_cast<std::size_t>(size(row[i] - left(i)));
    sumAbove += static_cast<std::size_t>(size(row[i] - above[i]));
  }
  const bool isLeft = sumLeft < sumAbove;
  out.push_back(isLeft ? 1 : 2);
  for (std::size_t i = 0; i < n; ++i)
    out.push_back(static_cast<std::uint8_t>(row[i] - (isLeft ? left(i) : above[i])));
}

}  // namespace

PngWriter::PngWriter(std::uint32_t width, std::uint32_t height)
    : rowBytes_(4 * static_cast<std::size_t>(width)), above_(rowBytes_, 0) {
  put32(header_, width);
  put32(header_, height);
  constexpr char kEightBits = 8, kRgba = 6;
  header_.append({kEightBits, kRgba, 0, 0, 0});
}

void PngWriter::addRows(const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> filtered;
  filtered.reserve(rgba.size() + rgba.size() / rowBytes_);
  for (std::size_t at = 0; at < rgba.size(); at += rowBytes_) {
    appendFiltered(&rgba[at], above_, filtered);
    above_.assign(rgba.begin() + static_cast<std::ptrdiff_t>(at),
                  rgba.begin() + static_cast<std::ptrdiff_t>(at + rowBytes_));
  }
  data_.add(filtered);
}

std::string PngWriter::finish() {
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header_) + chunk("IDAT", data_.finish()) +
         chunk("IEND", {});
}

}  // namespace abflat
