#include "pack/free_map.h"

#include <algorithm>

#include "pack/bits.h"

namespace abflat {

FreeMap::FreeMap(int width, int height)
    : width_(width),
      height_(height),
      levels_(floorLog2(static_cast<std::uint32_t>(width)) + 1),
      // Reading 64 bits from any cell stays inside.
      stride_(static_cast<std::size_t>(width) / 64 + 2),
      words_(stride_ * static_cast<std::size_t>(levels_) * static_cast<std::size_t>(height)),
      longest_(static_cast<std::size_t>(height), width),
      places_(stride_),
      scratch_(stride_) {
  for (int k = 0; k < levels_; ++k) {
    const int places = width - (1 << k) + 1;
    for (int y = 0; y < height; ++y) {
      std::uint64_t* const r = row(k, y);
      for (int w = 0; w < places / 64; ++w) r[w] = ~std::uint64_t{0};
      if (places % 64) r[places / 64] = (std::uint64_t{1} << places % 64) - 1;
    }
  }
}

double FreeMap::freeCells() const {
  double count = 0;
  const std::size_t end = rowBegin(1, 0);
  for (std::size_t w = 0; w < end; ++w) count += countBits(words_[w]);
  return count;
}

bool FreeMap::fitsRuns(const Footprint& footprint, int y) const {
  for (const Run& run : footprint.runs)
    if (run.last - run.first >= longest_[static_cast<std::size_t>(y + run.row)]) return false;
  return true;
}

int FreeMap::findInRow(const Footprint& footprint, int y) {
  int begin = 0, end = (width_ - footprint.width) / 64 + 1;
  bool isFirst = true;
  for (const Run& run : footprint.runs) {
    const int length = run.last - run.first + 1;
    const int level = floorLog2(static_cast<std::uint32_t>(length));
    const std::uint64_t* const r = row(level, y + run.row);
    const int a = run.first, b = run.last + 1 - (1 << level);
    if (isFirst) {
      for (int w = begin; w < end; ++w)
        places_[w] = bitsFrom(r, 64 * w + a) & bitsFrom(r, 64 * w + b);
      isFirst = false;
    } else {
      for (int w = begin; w < end; ++w)
        if (places_[w]) places_[w] &= bitsFrom(r, 64 * w + a) & bitsFrom(r, 64 * w + b);
    }
    while (begin < end && !places_[begin]) ++begin;
    while (begin < end && !places_[end - 1]) --end;
    if (begin == end) return -1;
  }
  // Places too far to the right are not free: level 0 ends at the border.
  return 64 * begin + lowestBit(places_[begin]);
}

Cell FreeMap::find(const Footprint& footprint, int begin, int end) {
  if (footprint.width > width_ || footprint.runs.empty()) return {};
  end = std::min(end, height_ - footprint.height + 1);
  for (int y = begin; y < end; ++y) {
    if (!fitsRuns(footprint, y)) continue;
    if (const int x = findInRow(footprint, y); x >= 0) return {x, y};
  }
  return {};
}

void FreeMap::take(const BitGrid& grid, int x, int y) {
  for (int i = std::max(0, -y); i < std::min(grid.height, height_ - y); ++i) {
    const std::uint64_t* const from = grid.row(i);
    std::uint64_t* const to = row(0, y + i);
    int first = width_, last = -1;
    for (int w = 0; w < static_cast<int>(grid.stride); ++w) {
      const int at = x + 64 * w;
      std::uint64_t bits = from[w];
      if (at >= width_ || at <= -64 || !bits) continue;
      if (at < 0) bits >>= -at;
      const int word = std::max(at, 0) >> 6, shift = std::max(at, 0) & 63;
      if (!bits) continue;
      to[word] &= ~(bits << shift);
      to[word + 1] &= ~(bits >> 1 >> (63 - shift));
      first = std::min(first, std::max(at, 0) + lowestBit(bits));
      last = std::max(last, std::max(at, 0) + highestBit(bits));
    }
    if (first <= last) update(y + i, first, std::min(last, width_ - 1));
  }
}

/// Cells first..last of a row have changed.
void FreeMap::update(int y, int first, int last) {
  for (int k = 1; k < levels_; ++k) {
    const std::uint64_t* const from = row(k - 1, y);
    std::uint64_t* const to = row(k, y);
    const int begin = std::max(0, first - (1 << k) + 1) >> 6;
    for (int w = begin; w <= last >> 6; ++w)
      to[w] = from[w] & bitsFrom(from, std::min(64 * w + (1 << (k - 1)), width_));
  }
  measureLongest(y);
}

void FreeMap::measureLongest(int y) {
  int level = levels_ - 1;
  const auto isEmpty = [this](const std::uint64_t* r) {
    std::uint64_t any = 0;
    for (std::size_t w = 0; w < stride_; ++w) any |= r[w];
    return !any;
  };
  while (level >= 0 && isEmpty(row(level, y))) --level;
  std::int32_t& longest = longest_[static_cast<std::size_t>(y)];
  if (level < 0) {
    longest = 0;
    return;
  }
  longest = 1 << level;
  std::copy_n(row(level, y), stride_, scratch_.data());
  while (level-- > 0) {
    std::uint64_t any = 0;
    const std::uint64_t* const r = row(level, y);
    for (std::size_t w = 0; w + 1 < stride_; ++w) {
      const int at = std::min(64 * static_cast<int>(w) + longest, width_);
      places_[w] = scratch_[w] & bitsFrom(r, at);
      any |= places_[w];
    }
    if (!any) continue;
    places_[stride_ - 1] = 0;
    std::swap(places_, scratch_);
    longest += 1 << level;
  }
}

}  // namespace abflat
