#include "pack/free_map.h"

#include <algorithm>

#include "pack/bits.h"

namespace abflat {

int FreeMap::levelsFor(int longest) const {
  return floorLog2(static_cast<std::uint32_t>(std::min(longest, width_))) + 1;
}

void FreeMap::limit(int longest) { levels_ = std::min(levels_, levelsFor(longest)); }

void FreeMap::shrink() {
  words_.resize(rowBegin(levels_, 0));
  words_.shrink_to_fit();
}

int FreeMap::mostFree() const {
  int most = 0;
  for (const FreeRun& run : longest_) most = std::max(most, static_cast<int>(run.length));
  return most;
}

void FreeMap::reset(int width, int height, int longest) {
  width_ = width;
  height_ = height;
  levels_ = levelsFor(longest);
  // Reading 64 bits from any cell stays inside.
  stride_ = static_cast<std::size_t>(width) / 64 + 2;
  words_.assign(rowBegin(levels_, 0), 0);
  longest_.assign(static_cast<std::size_t>(height), {0, width});
  places_.resize(stride_);
  scratch_.resize(stride_);
  for (int k = 0; k < levels_; ++k) {
    const int places = width - (1 << k) + 1;
    for (int y = 0; y < height; ++y) {
      std::uint64_t* const r = row(k, y);
      for (int w = 0; w < places / 64; ++w) r[w] = ~std::uint64_t{0};
      if (places % 64) r[places / 64] = (std::uint64_t{1} << places % 64) - 1;
    }
  }
}

/// The first row from y on at which the first runs of the footprint are no longer than the free run
/// in their rows; `end` if there is none.
int FreeMap::firstHopeful(const Footprint& footprint, int y, int end) const {
  constexpr std::size_t kLooks = 24;
  const std::size_t count = std::min(footprint.runs.size(), kLooks);
  for (std::size_t k = 0, good = 0; good < count && y < end;) {
    const Run& run = footprint.runs[k];
    const int row = y + run.row;
    const int length = longest_[static_cast<std::size_t>(row)].length;
    if (run.last - run.first < length) {
      ++good;
      k = k + 1 < count ? k + 1 : 0;
      continue;
    }
    // Advance until all too-long runs of the footprint have moved past that row.
    good = 0;
    while (y < end && y <= row && footprint.longest[static_cast<std::size_t>(row - y)] > length)
      ++y;
  }
  return y;
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
  for (int y = firstHopeful(footprint, begin, end); y < end;
       y = firstHopeful(footprint, y + 1, end))
    if (const int x = findInRow(footprint, y); x >= 0) return {x, y};
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

/// Updates the map after cells first..last of a row have changed.
void FreeMap::update(int y, int first, int last) {
  for (int k = 1; k < levels_; ++k) {
    const std::uint64_t* const from = row(k - 1, y);
    std::uint64_t* const to = row(k, y);
    const int begin = std::max(0, first - (1 << k) + 1) >> 6;
    for (int w = begin; w <= last >> 6; ++w)
      to[w] = from[w] & bitsFrom(from, std::min(64 * w + (1 << (k - 1)), width_));
  }
  const FreeRun& longest = longest_[static_cast<std::size_t>(y)];
  if (last >= longest.begin && first < longest.begin + longest.length) boundLongest(y);
}

void FreeMap::boundLongest(int y) {
  FreeRun& longest = longest_[static_cast<std::size_t>(y)];
  // It cannot have grown. Runs longer than all levels together are never asked for.
  int level = std::min(floorLog2(static_cast<std::uint32_t>(longest.length)), levels_ - 1);
  // scratch_: where `length` free cells begin; length grows by ever smaller powers of two.
  int length = 0;
  for (; level >= 0 && length < 8 << level; --level) {
    const std::uint64_t* const r = row(level, y);
    std::uint64_t any = 0;
    for (std::size_t w = 0; w + 1 < stride_; ++w) {
      const int at = std::min(64 * static_cast<int>(w) + length, width_);
      places_[w] = length ? scratch_[w] & bitsFrom(r, at) : r[w];
      any |= places_[w];
    }
    if (!any) continue;
    std::swap(places_, scratch_);
    length += 1 << level;
  }
  longest = {};
  if (length == 0) return;
  std::size_t w = 0;
  while (!scratch_[w]) ++w;
  longest.begin = 64 * static_cast<std::int32_t>(w) + lowestBit(scratch_[w]);
  longest.length = length + (1 << (level + 1)) - 1;
}

}  // namespace abflat
