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

/// Free cells of one tile. Level k has a bit where 2^k free cells begin, so that two words tell for
/// 64 places at once whether a run of any length is free there.
class FreeMap {
 public:
  /// Frees all cells. `longest`: longest run of the footprints that will be looked for; the
  /// shorter, the faster.
  void reset(int width, int height, int longest);

  /// From now on no longer runs will be looked for, which saves time.
  void limit(int longest);

  /// Drops the memory that this left unused.
  void shrink();

  /// Upper bound on the number of consecutive free cells in any row.
  int mostFree() const;

  int width() const { return width_; }
  int height() const { return height_; }

  /// The lowest row from `begin` on and before `end`, and in it the first cell, at which the whole
  /// footprint is free.
  Cell find(const Footprint& footprint, int begin, int end);

  /// Takes the cells of a grid whose cell (0, 0) is put at (x, y); cells outside the tile are
  /// ignored.
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

  /// The longest run of free cells in a row, up to an eighth too long, and where it begins.
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
