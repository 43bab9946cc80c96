#pragma once

#include <vector>

namespace abflat {

/// An entry of a matrix, as Eigen reads it.
class SparseEntry {
 public:
  SparseEntry() = default;
  SparseEntry(int row, int column, double value) : row_(row), column_(column), value_(value) {}

  int row() const { return row_; }
  int col() const { return column_; }
  double value() const { return value_; }

 private:
  int row_ = 0, column_ = 0;
  double value_ = 0;
};

/// In any order; entries at the same place add up.
using SparseEntries = std::vector<SparseEntry>;

}  // namespace abflat
