#pragma once

#include <cstdint>
#include <vector>

#include "pack/cover.h"

namespace abflat {

/// Cells that a shape needs, as runs in the order in which they are best tested.
struct Footprint {
  int width = 0, height = 0;
  std::vector<Run> runs;
  std::vector<std::int32_t> longest;  ///< cells of the longest run of each row

  /// The longest run comes first, then rows far apart: what does not fit shows early.
  void set(const BitGrid& grid);

  /// Another one with left and right swapped, below and above swapped, or both.
  void setMirrored(const Footprint& from, bool acrossX, bool acrossY);

 private:
  std::vector<Run> inOrder_;
};

}  // namespace abflat
