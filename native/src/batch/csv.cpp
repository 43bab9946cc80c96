#include "batch/csv.h"

namespace abflat::cli {
namespace {

constexpr const char* kByteOrderMark = "\xEF\xBB\xBF";

/// Reads a text from front to back.
class CsvText {
 public:
  explicit CsvText(const std::string& text) : text_(text) {
    if (text.compare(0, 3, kByteOrderMark) == 0) at_ = 3;
  }

  bool isAtEnd() const { return at_ >= text_.size(); }

  CsvRow row() {
    CsvRow out{line_, {}};
    for (bool hasNext = true; hasNext;) {
      out.cells.push_back(cell());
      hasNext = !isAtEnd() && text_[at_] == ',';
      if (hasNext) ++at_;
    }
    if (!isAtEnd()) next();  // the end of the line
    return out;
  }

 private:
  char next() {
    const char c = text_[at_++];
    if (c == '\n') ++line_;
    return c;
  }

  std::string cell() {
    if (!isAtEnd() && text_[at_] == '"') return quotedCell();
    std::string out;
    while (!isAtEnd() && text_[at_] != ',' && text_[at_] != '\n') out += next();
    if (!out.empty() && out.back() == '\r') out.pop_back();
    return out;
  }

  std::string quotedCell() {
    std::string out;
    for (++at_; !isAtEnd();) {
      const char c = next();
      if (c != '"') {
        out += c;
        continue;
      }
      if (isAtEnd() || text_[at_] != '"') break;
      out += next();
    }
    while (!isAtEnd() && text_[at_] != ',' && text_[at_] != '\n') next();
    return out;
  }

  const std::string& text_;
  std::size_t at_ = 0, line_ = 1;
};

}  // namespace

std::vector<CsvRow> csvRows(const std::string& text) {
  std::vector<CsvRow> out;
  for (CsvText rest(text); !rest.isAtEnd();) {
    CsvRow row = rest.row();
    if (row.cells.size() > 1 || !row.cells[0].empty()) out.push_back(std::move(row));
  }
  return out;
}

}  // namespace abflat::cli
