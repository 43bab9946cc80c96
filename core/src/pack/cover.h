#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pack/outline.h"

namespace abflat {

/// Bits of a grid, row by row.
struct BitGrid {
  int width = 0, height = 0;
  std::size_t stride = 0;  ///< words per row
  std::vector<std::uint64_t> words;

  void reset(int newWidth, int newHeight);
  std::uint64_t* row(int y) { return words.data() + stride * static_cast<std::size_t>(y); }
  const std::uint64_t* row(int y) const {
    return words.data() + stride * static_cast<std::size_t>(y);
  }
  bool at(int x, int y) const { return row(y)[x >> 6] >> (x & 63) & 1; }
  /// Sets cells first..last of a row; ignores those outside the grid.
  void set(int y, int first, int last);
};

/// Swaps rows and columns.
void transpose(const BitGrid& from, BitGrid& to);

/// Half as many cells along each side; a cell is set if any of its four is. Leftover cells at the
/// right and top are dropped.
BitGrid halved(const BitGrid& grid);

/// Sets in `to` what is set in `grid`. Both have the same size, or `to` is empty.
void add(const BitGrid& grid, BitGrid& to);

double countCells(const BitGrid& grid);

/// Covered cells first..last of a row.
struct Run {
  std::int32_t row, first, last;
};

/// Rasterizes polygons to cells. Keeps its work space from one call to the next.
class Cover {
 public:
  /// Covers all cells (closed unit squares) at most `slack` away, along either axis, from the
  /// covered area, despite rounding errors. Cells outside the grid are dropped. `slack` must be
  /// well above the rounding errors of the coordinates.
  void cover(const Loops& loops, double slack, BitGrid& grid);

 private:
  struct Crossing {
    std::int32_t row, column, direction;
  };

  void coverEdge(PlanePoint a, PlanePoint b, double slack, BitGrid& grid);
  void fill(BitGrid& grid);

  std::vector<Crossing> crossings_, sorted_;
  std::vector<std::uint32_t> begin_;
};

/// Ordered by row, then by cell.
void appendRuns(const BitGrid& grid, std::vector<Run>& runs);

}  // namespace abflat
