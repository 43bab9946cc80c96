#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace abflat::cli {

struct CsvRow {
  std::size_t line = 0;  ///< where it begins, from 1
  std::vector<std::string> cells;
};

/// The rows of a CSV text (RFC 4180), without empty lines.
std::vector<CsvRow> csvRows(const std::string& text);

}  // namespace abflat::cli
