#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace abflat::cli {

/// A cell: `exact` for programs, `shown` for readers.
struct Cell {
  std::string exact, shown;

  Cell() = default;
  Cell(const std::string& text) : exact(text), shown(text) {}
  Cell(const char* text) : exact(text), shown(text) {}
  Cell(std::size_t count) : exact(std::to_string(count)), shown(exact) {}
  Cell(double value, int decimals);
};

struct Column {
  std::string name;
  bool isText = false;  ///< left-aligned, and quoted in CSV
};

/// Rows may be shorter than the columns; missing cells are empty.
struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
};

std::string csvText(const Table& table);
std::string markdownText(const Table& table);
std::string htmlText(const Table& table);

}  // namespace abflat::cli
