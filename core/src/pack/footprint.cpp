#include "pack/footprint.h"

#include <algorithm>

#include "pack/bits.h"

namespace abflat {
namespace {

int lengthOf(const Run& run) { return run.last - run.first; }

/// 0, n/2, n/4, 3n/4, ...: the bits of the index in reverse.
std::uint32_t spread(std::uint32_t i, int bits) {
  std::uint32_t out = 0;
  for (int b = 0; b < bits; ++b) out |= (i >> b & 1) << (bits - 1 - b);
  return out;
}

}  // namespace

Footprint footprintOf(const BitGrid& grid) {
  Footprint out;
  out.width = grid.width;
  out.height = grid.height;
  std::vector<Run> runs;
  appendRuns(grid, runs);
  if (runs.empty()) return out;
  std::swap(*std::max_element(runs.begin(), runs.end(),
                              [](const Run& a, const Run& b) { return lengthOf(a) < lengthOf(b); }),
            runs.front());
  out.runs.reserve(runs.size());
  const int bits = runs.size() < 2 ? 0 : floorLog2(static_cast<std::uint32_t>(runs.size() - 1)) + 1;
  for (std::uint32_t i = 0; i < std::uint32_t{1} << bits; ++i) {
    const std::uint32_t k = spread(i, bits);
    if (k < runs.size()) out.runs.push_back(runs[k]);
  }
  return out;
}

}  // namespace abflat
