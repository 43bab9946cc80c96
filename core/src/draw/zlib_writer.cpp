#include "draw/zlib_writer.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace abflat {
namespace {

constexpr std::uint32_t kEndOfBlock = 256, kFirstLength = 257;
constexpr std::size_t kWindow = 32768, kShortest = 3, kLongest = 258;

/// How RFC 1951 writes a length or a distance: in steps that double, with extra bits.
struct Step {
  std::uint32_t symbol, base;
  int extraBits;
};

/// Four lengths, or two distances, of one step share the number of extra bits.
Step stepOf(std::uint32_t value, std::uint32_t least, int log2PerOctave) {
  const std::uint32_t offset = value - least;
  const std::uint32_t perOctave = 1u << log2PerOctave;
  if (offset < 2 * perOctave) return {offset, value, 0};
  int bits = 0;
  while ((offset >> bits) >= 2 * perOctave) ++bits;
  const std::uint32_t high = offset >> bits;
  return {perOctave * static_cast<std::uint32_t>(bits) + high, least + (high << bits), bits};
}

/// Where the same bytes stood before: the latest place for each hash of three bytes.
class Places {
 public:
  Places() { last_.fill(kNowhere); }
  std::size_t swap(const std::uint8_t* bytes, std::size_t at) {
    const std::uint32_t three = static_cast<std::uint32_t>(bytes[0]) |
                                static_cast<std::uint32_t>(bytes[1]) << 8 |
                                static_cast<std::uint32_t>(bytes[2]) << 16;
    std::size_t& last = last_[three * 2654435761u >> (32 - kBits)];
    const std::size_t before = last;
    last = at;
    return before;
  }
  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

 private:
  static constexpr int kBits = 14;
  std::array<std::size_t, 1 << kBits> last_{};
};

std::size_t commonLength(const std::uint8_t* a, const std::uint8_t* b, std::size_t most) {
  std::size_t n = 0;
  while (n < most && a[n] == b[n]) ++n;
  return n;
}

}  // namespace

void ZlibWriter::putBits(std::uint32_t bits, int count) {
  pending_ |= static_cast<std::uint64_t>(bits) << pendingCount_;
  for (pendingCount_ += count; pendingCount_ >= 8; pendingCount_ -= 8) {
    out_ += static_cast<char>(pending_ & 0xff);
    pending_ >>= 8;
  }
}

/// Codes begin with their highest bit.
void ZlibWriter::putCode(std::uint32_t code, int length) {
  std::uint32_t reversed = 0;
  for (int i = 0; i < length; ++i) reversed |= (code >> i & 1u) << (length - 1 - i);
  putBits(reversed, length);
}

/// The fixed codes of RFC 1951, 3.2.6.
void ZlibWriter::putLiteral(std::uint32_t symbol) {
  if (symbol < 144)
    putCode(0x30 + symbol, 8);
  else if (symbol < 256)
    putCode(0x190 + symbol - 144, 9);
  else if (symbol < 280)
    putCode(symbol - 256, 7);
  else
    putCode(0xc0 + symbol - 280, 8);
}

void ZlibWriter::putMatch(std::uint32_t length, std::uint32_t distance) {
  constexpr std::uint32_t kLongestSymbol = 285;
  if (length == kLongest) {
    putLiteral(kLongestSymbol);
  } else {
    const Step step = stepOf(length, kShortest, 2);
    putLiteral(kFirstLength + step.symbol);
    putBits(length - step.base, step.extraBits);
  }
  const Step step = stepOf(distance, 1, 1);
  putCode(step.symbol, 5);
  putBits(distance - step.base, step.extraBits);
}

void ZlibWriter::add(const std::vector<std::uint8_t>& bytes) {
  for (const std::uint8_t byte : bytes) {
    constexpr std::uint32_t kAdler = 65521;
    adlerA_ = (adlerA_ + byte) % kAdler;
    adlerB_ = (adlerB_ + adlerA_) % kAdler;
  }
  putBits(0b010, 3);  // a block that is not the last, with fixed codes
  Places places;
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t room = std::min(kLongest, bytes.size() - i);
    std::size_t length = 0, from = Places::kNowhere;
    if (room >= kShortest) {
      from = places.swap(&bytes[i], i);
      if (from != Places::kNowhere && i - from <= kWindow)
        length = commonLength(&bytes[i], &bytes[from], room);
    }
    if (length < kShortest) {
      putLiteral(bytes[i++]);
      continue;
    }
    putMatch(static_cast<std::uint32_t>(length), static_cast<std::uint32_t>(i - from));
    i += length;
  }
  putLiteral(kEndOfBlock);
}

std::string ZlibWriter::finish() {
  putBits(0b011, 3);  // the last block, which is empty
  putLiteral(kEndOfBlock);
  if (pendingCount_ > 0) putBits(0, 8 - pendingCount_);
  for (const std::uint32_t half : {adlerB_, adlerA_}) {
    out_ += static_cast<char>(half >> 8);
    out_ += static_cast<char>(half & 0xff);
  }
  return std::move(out_);
}

}  // namespace abflat
