#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "abflat/status.h"
#include "files/paths.h"
#include "files/read_file.h"

namespace abflat::cli {

/// A vertex or face number: digits only.
inline bool readIndex(std::istream& in, std::uint32_t& index) {
  std::string word;
  if (!(in >> word) || word.find_first_not_of("0123456789") != std::string::npos) return false;
  return static_cast<bool>(std::istringstream(word) >> index);
}

/// Reads the rows of a text file (standard input for "-"), one per line; blank lines and # comments
/// are skipped. `read(in, row)` must consume the whole line. Errors: UnreadableFile, ParseError
/// (names file and line, and says what is `expected`).
template <class Row, class Read>
Result<std::vector<Row>> readRows(const std::string& path, const char* expected, const Read& read) {
  const Result<std::string> text = readBytes(path);
  if (!text.ok()) return text.status();
  std::istringstream in(text.value());
  std::vector<Row> rows;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    if ((words >> std::ws).eof()) continue;
    Row row{};
    if (!read(words, row) || !(words >> std::ws).eof())
      return Status{StatusCode::ParseError,
                    inputName(path) + ":" + std::to_string(number) + ": expected " + expected};
    rows.push_back(row);
  }
  return rows;
}

}  // namespace abflat::cli
