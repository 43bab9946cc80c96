#include "batch/list_file.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "batch/csv.h"
#include "files/paths.h"
#include "files/read_file.h"

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Names and values of one line, in their order.
struct ListRow {
  std::size_t line = 0;
  std::vector<std::pair<std::string, std::string>> cells;
};

constexpr const char *kInputKey = "input", *kAtlasKey = "atlas";

/// "max-stretch", "maxStretch" and "--max-stretch" are the same option.
std::string flagOf(const std::string& key) {
  std::string out = "--";
  for (const char c : key.substr(std::min(key.find_first_not_of('-'), key.size())))
    out += c >= 'A' && c <= 'Z' ? std::string("-") + static_cast<char>(c - 'A' + 'a')
                                : std::string(1, c);
  return out;
}

/// As on the command line: 2048, "none", true, or a width and a height as [2048, 1024].
std::string cellText(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return value.get<std::string>();
  if (value.is_array() && value.size() == 2) return value[0].dump() + "x" + value[1].dump();
  return value.dump();
}

class ListReader {
 public:
  ListReader(const std::string& path, const std::vector<OptionOfCommand>& known)
      : path_(path),
        folder_(path == kStandardStream ? fs::path() : fs::path(path).parent_path()),
        known_(known) {}

  Result<std::vector<BatchInput>> read(const std::string& text) {
    const Result<std::vector<ListRow>> rows = rowsIn(text);
    if (!rows.ok()) return rows.status();
    std::vector<BatchInput> out;
    for (const ListRow& row : rows.value()) {
      Result<BatchInput> input = inputOf(row);
      if (!input.ok()) return input.status();
      out.push_back(std::move(input.value()));
    }
    return out;
  }

 private:
  Status wrong(std::size_t line, const std::string& what,
               StatusCode code = StatusCode::ParseError) const {
    return {code, inputName(path_) + ":" + std::to_string(line) + ": " + what};
  }

  Result<std::vector<ListRow>> rowsIn(const std::string& text) const {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first != std::string::npos && text[first] == '{') return jsonRows(text);
    const std::vector<CsvRow> table = csvRows(text);
    const bool hasNames = !table.empty() && std::find(table[0].cells.begin(), table[0].cells.end(),
                                                      kInputKey) != table[0].cells.end();
    if (hasNames) return csvListRows(table);
    return plainRows(text);
  }

  static std::vector<ListRow> plainRows(const std::string& text) {
    std::vector<ListRow> out;
    std::istringstream lines(text);
    std::string line;
    for (std::size_t number = 1; std::getline(lines, line); ++number) {
      while (!line.empty() && line.back() == '\r') line.pop_back();
      if (!line.empty() && line[0] != '#') out.push_back({number, {{kInputKey, line}}});
    }
    return out;
  }

  Result<std::vector<ListRow>> csvListRows(const std::vector<CsvRow>& table) const {
    std::vector<ListRow> out;
    const std::vector<std::string>& names = table[0].cells;
    for (std::size_t i = 1; i < table.size(); ++i) {
      const auto& [line, cells] = table[i];
      if (cells.size() != names.size())
        return wrong(line, "there are " + std::to_string(cells.size()) + " cells, but " +
                               std::to_string(names.size()) + " columns have names");
      ListRow& row = out.emplace_back(ListRow{line, {}});
      for (std::size_t c = 0; c < cells.size(); ++c) row.cells.emplace_back(names[c], cells[c]);
    }
    return out;
  }

  Result<std::vector<ListRow>> jsonRows(const std::string& text) const {
    std::vector<ListRow> out;
    std::istringstream lines(text);
    std::string line;
    for (std::size_t number = 1; std::getline(lines, line); ++number) {
      if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
      const Json value = Json::parse(line, nullptr, false);
      if (!value.is_object()) return wrong(number, "expected a JSON object in one line");
      ListRow& row = out.emplace_back(ListRow{number, {}});
      for (const auto& [key, cell] : value.items()) row.cells.emplace_back(key, cellText(cell));
    }
    return out;
  }

  Result<BatchInput> inputOf(const ListRow& row) const {
    BatchInput out;
    out.isListed = true;
    for (const auto& [key, text] : row.cells) {
      if (text.empty()) continue;  // as everywhere else
      if (key == kInputKey) {
        out.path = (folder_ / text).string();
        out.name = nameBelow(text);
        continue;
      }
      if (key == kAtlasKey) {
        out.atlas = nameBelow(text);
        if (out.atlas.empty()) return wrong(row.line, "\"" + text + "\" is no name for an atlas");
        continue;
      }
      Result<GivenOption> option = optionOf(row.line, key, text);
      if (!option.ok()) return option.status();
      out.options.push_back(std::move(option.value()));
    }
    if (out.name.empty()) return wrong(row.line, "no mesh is named as \"input\"");
    return out;
  }

  Result<GivenOption> optionOf(std::size_t line, const std::string& key,
                               const std::string& text) const {
    const std::string flag = flagOf(key);
    const auto found = std::find_if(known_.begin(), known_.end(),
                                    [&](const OptionOfCommand& o) { return o.flag == flag; });
    if (found == known_.end())
      return wrong(line, "there is no option \"" + key + "\" for single meshes",
                   StatusCode::InvalidOption);
    if (!found->hasValue && text != "true" && text != "false")
      return wrong(line, "\"" + key + "\" must be true or false, not " + text,
                   StatusCode::InvalidOption);
    return GivenOption{flag, text};
  }

  const std::string& path_;
  const fs::path folder_;
  const std::vector<OptionOfCommand>& known_;
};

}  // namespace

Result<std::vector<BatchInput>> readList(const std::string& path,
                                         const std::vector<OptionOfCommand>& known) {
  const Result<std::string> text = readBytes(path);
  if (!text.ok()) return text.status();
  return ListReader(path, known).read(text.value());
}

}  // namespace abflat::cli
