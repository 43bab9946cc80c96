#include "pack/cover.h"

#include <algorithm>
#include <cmath>

#include "pack/bits.h"

namespace abflat {
namespace {

/// floor, clamped to stay near the grid.
int cell(double x, double size) {
  const double near = std::min(std::max(x, -1.0), size);
  const int truncated = static_cast<int>(near);
  return truncated - (near < truncated ? 1 : 0);
}

/// Moves bit i of word k to bit k of word i, by swapping halves of ever smaller squares.
void transpose64(std::uint64_t* words) {
  std::uint64_t mask = 0x00000000FFFFFFFF;
  for (int size = 32; size > 0; size /= 2, mask ^= mask << size) {
    for (int k = 0; k < 64; k = (k + size + 1) & ~size) {
      const std::uint64_t swapped = (words[k] >> size ^ words[k + size]) & mask;
      words[k] ^= swapped << size;
      words[k + size] ^= swapped;
    }
  }
}

}  // namespace

void BitGrid::reset(int newWidth, int newHeight) {
  width = newWidth;
  height = newHeight;
  stride = static_cast<std::size_t>(newWidth + 63) / 64;
  words.assign(stride * static_cast<std::size_t>(newHeight), 0);
}

void BitGrid::set(int y, int first, int last) {
  first = std::max(first, 0);
  last = std::min(last, width - 1);
  if (y < 0 || y >= height || first > last) return;
  std::uint64_t* const r = row(y);
  const int a = first >> 6, b = last >> 6;
  const std::uint64_t head = ~std::uint64_t{0} << (first & 63);
  const std::uint64_t tail = ~std::uint64_t{0} >> (63 - (last & 63));
  if (a == b) {
    r[a] |= head & tail;
    return;
  }
  r[a] |= head;
  for (int i = a + 1; i < b; ++i) r[i] = ~std::uint64_t{0};
  r[b] |= tail;
}

/// Marks the cells along an edge, and notes where it crosses the middles of rows. For a crossing
/// any cell of the edge in that row will do: the winding number only matters where there is no
/// edge.
void Cover::coverEdge(PlanePoint a, PlanePoint b, double slack, BitGrid& grid) {
  const std::int32_t direction = a.y < b.y ? 1 : -1;
  if (direction < 0) std::swap(a, b);
  const double least = std::min(a.x, b.x), most = std::max(a.x, b.x);
  const double gridWidth = grid.width, gridHeight = grid.height;
  const int firstRow = std::max(cell(a.y - slack, gridHeight), 0);
  const int lastRow = std::min(cell(b.y + slack, gridHeight), grid.height - 1);
  const double rise = b.y - a.y;
  // Below this, the slope would magnify the rounding errors of y beyond the slack.
  const bool isFlat = firstRow == lastRow || !(rise > slack * 0x1p-12);
  const double slope = isFlat ? 0 : (b.x - a.x) / rise;
  for (int y = firstRow; y <= lastRow; ++y) {
    double x0 = least, x1 = most;
    if (!isFlat) {
      const double from = a.x + slope * (std::max(a.y, y - slack) - a.y);
      const double to = a.x + slope * (std::min(b.y, y + 1 + slack) - a.y);
      x0 = std::max(std::min(from, to), least);
      x1 = std::min(std::max(from, to), most);
    }
    const int first = cell(x0 - slack, gridWidth);
    grid.set(y, first, cell(x1 + slack, gridWidth));
    const double middle = y + 0.5;
    if (a.y <= middle && middle < b.y) crossings_.push_back({y, first, direction});
  }
}

void Cover::fill(BitGrid& grid) {
  begin_.assign(static_cast<std::size_t>(grid.height) + 2, 0);
  for (const Crossing& c : crossings_) ++begin_[static_cast<std::size_t>(c.row) + 2];
  for (std::size_t y = 2; y < begin_.size(); ++y) begin_[y] += begin_[y - 1];
  sorted_.resize(crossings_.size());
  for (const Crossing& c : crossings_) sorted_[begin_[static_cast<std::size_t>(c.row) + 1]++] = c;
  for (int y = 0; y < grid.height; ++y) {
    Crossing* const first = sorted_.data() + begin_[static_cast<std::size_t>(y)];
    Crossing* const end = sorted_.data() + begin_[static_cast<std::size_t>(y) + 1];
    std::sort(first, end, [](const Crossing& a, const Crossing& b) {
      return a.column != b.column ? a.column < b.column : a.direction < b.direction;
    });
    std::int32_t winding = 0;
    for (const Crossing* c = first; c + 1 < end; ++c) {
      winding += c->direction;
      if (winding != 0) grid.set(y, c->column, c[1].column);
    }
  }
}

void Cover::cover(const Loops& loops, double slack, BitGrid& grid) {
  std::size_t begin = 0;
  crossings_.clear();
  for (std::size_t k = 0; k < loops.ends.size(); ++k) {
    const std::size_t end = loops.ends[k];
    for (std::size_t i = begin; i < end; ++i) {
      const PlanePoint a = loops.points[i], b = loops.points[i + 1 < end ? i + 1 : begin];
      coverEdge(a, b, slack, grid);
    }
    begin = end;
    if (!loops.isGroup[k]) continue;
    if (!crossings_.empty()) fill(grid);
    crossings_.clear();
  }
}

void transpose(const BitGrid& from, BitGrid& to) {
  to.reset(from.height, from.width);
  std::uint64_t square[64];
  for (int y = 0; y < from.height; y += 64) {
    for (int x = 0; x < from.width; x += 64) {
      for (int k = 0; k < 64; ++k) square[k] = y + k < from.height ? from.row(y + k)[x >> 6] : 0;
      transpose64(square);
      for (int k = 0; k < std::min(64, from.width - x); ++k) to.row(x + k)[y >> 6] = square[k];
    }
  }
}

BitGrid halved(const BitGrid& grid) {
  BitGrid out;
  out.reset(grid.width / 2, grid.height / 2);
  for (int y = 0; y < 2 * out.height; ++y)
    for (int x = 0; x < 2 * out.width; ++x)
      if (grid.at(x, y)) out.set(y / 2, x / 2, x / 2);
  return out;
}

void add(const BitGrid& grid, BitGrid& to) {
  if (to.words.empty()) {
    to = grid;
    return;
  }
  for (std::size_t w = 0; w < to.words.size(); ++w) to.words[w] |= grid.words[w];
}

double countCells(const BitGrid& grid) {
  double count = 0;
  for (const std::uint64_t word : grid.words) count += countBits(word);
  return count;
}

void appendRuns(const BitGrid& grid, std::vector<Run>& runs) {
  for (int y = 0; y < grid.height; ++y) {
    const std::uint64_t* const row = grid.row(y);
    bool isInside = false;
    for (int w = 0; w < static_cast<int>(grid.stride); ++w) {
      // A bit is set where a run begins or ends.
      std::uint64_t edges = row[w] ^ (row[w] << 1 | (isInside ? 1 : 0));
      for (; edges; edges &= edges - 1) {
        const int x = 64 * w + lowestBit(edges);
        if (isInside)
          runs.back().last = x - 1;
        else
          runs.push_back({y, x, grid.width - 1});
        isInside = !isInside;
      }
    }
  }
}

}  // namespace abflat
