#pragma once

#include <cstdint>
#include <vector>

namespace abflat {

/// Symmetric matrix stored by rows: the diagonal entry of each first, then those right of it, which
/// is the lower triangle by columns as Eigen::SparseMatrix<double> stores it. Owns nothing.
struct HalfMatrix {
  std::uint32_t rows = 0;
  const int* start = nullptr;  ///< size rows + 1
  const int* column = nullptr;
  const double* value = nullptr;

  double diagonal(std::uint32_t i) const { return value[start[i]]; }
  /// visit(j, value) for all j > i.
  template <typename Visit>
  void forEachRight(std::uint32_t i, Visit&& visit) const {
    for (int k = start[i] + 1; k < start[i + 1]; ++k)
      visit(static_cast<std::uint32_t>(column[k]), value[k]);
  }
};

/// Entries by rows.
struct CompressedRows {
  std::vector<int> start{0};  ///< size rows + 1
  std::vector<int> column;
  std::vector<double> value;

  std::uint32_t rows() const { return static_cast<std::uint32_t>(start.size() - 1); }
  HalfMatrix asHalf() const { return {rows(), start.data(), column.data(), value.data()}; }
  void push(std::uint32_t j, double entry) {
    column.push_back(static_cast<int>(j));
    value.push_back(entry);
  }
  void endRow() { start.push_back(static_cast<int>(column.size())); }
  template <typename Visit>
  void forEach(std::uint32_t i, Visit&& visit) const {
    for (int k = start[i]; k < start[i + 1]; ++k)
      visit(static_cast<std::uint32_t>(column[k]), value[k]);
  }
  std::uint64_t bytes() const {
    return sizeof(int) * (start.capacity() + column.capacity()) + sizeof(double) * value.capacity();
  }
};

}  // namespace abflat
