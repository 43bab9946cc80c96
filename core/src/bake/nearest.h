#pragma once

#include <cstdint>
#include <vector>

namespace abflat {

/// No row or column.
constexpr std::int32_t kNowhere = -1;

/// The nearest covered texel of each texel of a row of the image.
class NearestInRow {
 public:
  /// `rows`: per column the row of the nearest covered texel in the column, or kNowhere.
  void find(std::int32_t row, const std::int32_t* rows, std::size_t width);

  /// Per column, the column of the nearest covered texel, whose row `rows` has; or kNowhere if
  /// nothing is covered. The first one of several.
  const std::vector<std::int32_t>& columns() const { return columns_; }

 private:
  std::vector<std::int32_t> columns_;
  std::vector<std::int32_t> sites_, begins_;
};

}  // namespace abflat
