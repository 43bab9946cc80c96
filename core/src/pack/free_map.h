#pragma once

#include <cstdint>
#include <vector>

#include "pack/cover.h"
#include "pack/footprint.h"

namespace abflat {

struct Cell {
  int x = -1, y = -1;

  bool isFound() const { return x >= 0; }
};

/// Free cells of one tile. Level k has a bit where 2^k free cells begin, so that two words tell of
/// 64 places at once whether a run of any length is free there.
class FreeMap {
 public:
  /// All cells free. `longest`: of the runs of footprints that will be looked for; the shorter, the
  /// faster.
  void reset(int width, int height, int longest);

  /// Runs that will be looked for are no longer than that from now on: less memory is needed.
  void limit(int longest);

  /// No row has more free cells side by side.
  int mostFree() const;

  int width() const { return width_; }
  int height() const { return height_; }

  /// The lowest row, and in it the first cell, from row `begin` and before row `end`, where all of
  /// the footprint is free.
  Cell find(const Footprint& footprint, int begin, int end);

  /// Takes the cells of a grid whose cell (0, 0) is put at (x, y); those outside do not matter.
  void take(const BitGrid& grid, int x, int y);

 private:
  int levelsFor(int longest) const;
  std::size_t rowBegin(int level, int y) const {
    return stride_ * (static_cast<std::size_t>(level) * static_cast<std::size_t>(height_) +
                      static_cast<std::size_t>(y));
  }
  std::uint64_t* row(int level, int y) { return words_.data() + rowBegin(level, y); }
  int firstHopeful(const Footprint& footprint, int y, int end) const;
  int findInRow(const Footprint& footprint, int y);
  void update(int y, int first, int last);
  void boundLongest(int y);

  /// The most free cells side by side in a row, up to an eighth too many, and where they begin.
  struct FreeRun {
    std::int32_t begin = 0, length = 0;
  };

  int width_ = 0, height_ = 0, levels_ = 0;
  std::size_t stride_ = 0;
  std::vector<std::uint64_t> words_;
  std::vector<FreeRun> longest_;  ///< of each row
  std::vector<std::uint64_t> places_, scratch_;
};

}  // namespace abflat
