#include "draw/png_writer.h"

#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace abflat {
namespace {

constexpr int kLevel = Z_DEFAULT_COMPRESSION;
constexpr uInt kRoom = 1u << 16;

void put32(std::string& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 0xff);
}

std::string chunk(std::string_view type, std::string_view data) {
  std::string out;
  put32(out, static_cast<std::uint32_t>(data.size()));
  out += type;
  out += data;
  const auto* typed = reinterpret_cast<const Bytef*>(out.data() + 4);
  put32(out, static_cast<std::uint32_t>(crc32_z(0, typed, out.size() - 4)));
  return out;
}

/// Differences from the pixel on the left (1) or above (2), whichever are smaller.
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
    : rowBytes_(4 * static_cast<std::size_t>(width)),
      above_(rowBytes_, 0),
      isReady_(deflateInit(&stream_, kLevel) == Z_OK) {
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
  compress(std::move(filtered), Z_NO_FLUSH);
}

Result<std::string> PngWriter::finish() {
  compress({}, Z_FINISH);
  if (!isReady_)
    return Status{StatusCode::OutOfMemory, "there is not enough memory to compress the picture"};
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header_) + chunk("IDAT", data_) + chunk("IEND", {});
}

void PngWriter::compress(std::vector<std::uint8_t> bytes, int flush) {
  if (!isReady_) return;
  stream_.next_in = bytes.data();
  stream_.avail_in = static_cast<uInt>(bytes.size());
  std::array<Bytef, kRoom> room{};
  do {
    stream_.next_out = room.data();
    stream_.avail_out = kRoom;
    deflate(&stream_, flush);
    data_.append(reinterpret_cast<const char*>(room.data()), kRoom - stream_.avail_out);
  } while (stream_.avail_out == 0);
}

}  // namespace abflat
