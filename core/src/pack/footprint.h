#pragma once

#include <cstdint>
#include <vector>

#include "pack/cover.h"

namespace abflat {

/// The cells that a shape needs, as runs in the best order for testing them.
struct Footprint {
  int width = 0, height = 0;
  std::vector<Run> runs;
  std::vector<std::int32_t> longest;  ///< cells of the longest run of each row

  /// Puts the longest run first, then rows far apart, so that misfits show early.
  void set(const BitGrid& grid);

  /// Copies another footprint, swapped left to right, top to bottom, or both.
  void setMirrored(const Footprint& from, bool acrossX, bool acrossY);

 private:
  std::vector<Run> inOrder_;
};

}  // namespace abflat
