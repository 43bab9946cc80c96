#include "draw/zlib_writer.h"

#include <algorithm>
#include <array>

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

std::size_t commonLength(const std::uint8_t* a, const std::uint8_t* b, std::size_t most) {
  std::size_t n = 0;
  while (n < most && a[n] == b[n]) ++n;
  return n;
}

struct Match {
  std::size_t length = 0, from = 0;
};

/// Where bytes stood before: the latest places for each hash of three of them.
class Places {
 public:
  explicit Places(const std::vector<std::uint8_t>& bytes) : bytes_(bytes), before_(kWindow) {
    last_.fill(kNowhere);
  }

  /// The longest of some matches for what begins at `at`; only of what was added.
  Match longest(std::size_t at) const {
    constexpr int kMostTries = 32;
    Match best;
    const std::size_t room = std::min(kLongest, bytes_.size() - at);
    if (room < kShortest) return best;
    std::size_t from = last_[hash(at)];
    for (int i = 0; i < kMostTries && from != kNowhere && at - from < kWindow; ++i) {
      const std::size_t length = commonLength(&bytes_[from], &bytes_[at], room);
      if (length > best.length) best = {length, from};
      if (best.length == room) break;
      from = before_[from % kWindow];
    }
    return best;
  }

  void add(std::size_t at) {
    if (bytes_.size() - at < kShortest) return;
    std::size_t& last = last_[hash(at)];
    before_[at % kWindow] = last;
    last = at;
  }

 private:
  static constexpr int kBits = 14;
  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

  std::uint32_t hash(std::size_t at) const {
    const std::uint32_t three = static_cast<std::uint32_t>(bytes_[at]) |
                                static_cast<std::uint32_t>(bytes_[at + 1]) << 8 |
                                static_cast<std::uint32_t>(bytes_[at + 2]) << 16;
    return three * 2654435761u >> (32 - kBits);
  }

  const std::vector<std::uint8_t>& bytes_;
  std::array<std::size_t, 1 << kBits> last_{};
  std::vector<std::size_t> before_;  ///< the place before of the same hash, by place in the window
};

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
  Places places(bytes);
  for (std::size_t i = 0; i < bytes.size();) {
    const Match match = places.longest(i);
    const bool isWorthIt = match.length >= kShortest;
    const std::size_t next = i + (isWorthIt ? match.length : 1);
    if (isWorthIt)
      putMatch(static_cast<std::uint32_t>(match.length),
               static_cast<std::uint32_t>(i - match.from));
    else
      putLiteral(bytes[i]);
    for (; i < next; ++i) places.add(i);
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
