#include "pack/footprint.h"

#include <algorithm>

#include "pack/bits.h"

namespace abflat {
namespace {

int lengthOf(const Run& run) { return run.last - run.first; }

}  // namespace

void Footprint::set(const BitGrid& grid) {
  width = grid.width;
  height = grid.height;
  inOrder_.clear();
  runs.clear();
  appendRuns(grid, inOrder_);
  if (inOrder_.empty()) return;
  const auto isShorter = [](const Run& a, const Run& b) { return lengthOf(a) < lengthOf(b); };
  std::swap(*std::max_element(inOrder_.begin(), inOrder_.end(), isShorter), inOrder_.front());
  longest.assign(static_cast<std::size_t>(height), 0);
  for (const Run& run : inOrder_) {
    std::int32_t& most = longest[static_cast<std::size_t>(run.row)];
    most = std::max(most, run.last + 1 - run.first);
  }
  const auto count = static_cast<std::uint32_t>(inOrder_.size());
  for (std::uint32_t step = 1 << floorLog2(count), first = 0; step > 0; step /= 2) {
    for (std::uint32_t i = first; i < count; i += first == 0 ? step : 2 * step)
      runs.push_back(inOrder_[i]);
    first = step / 2;
  }
}

void Footprint::setMirrored(const Footprint& from, bool acrossX, bool acrossY) {
  width = from.width;
  height = from.height;
  runs = from.runs;
  for (Run& run : runs) {
    if (acrossX) run = {run.row, width - 1 - run.last, width - 1 - run.first};
    if (acrossY) run.row = height - 1 - run.row;
  }
  longest = from.longest;
  if (acrossY) std::reverse(longest.begin(), longest.end());
}

}  // namespace abflat
