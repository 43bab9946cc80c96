#include "reproduce/table.h"

#include <iomanip>
#include <sstream>

#include "terminal/markup.h"

namespace abflat::cli {
namespace {

const Cell& cellAt(const std::vector<Cell>& row, std::size_t i) {
  static const Cell empty;
  return i < row.size() ? row[i] : empty;
}

/// Quoted, since sentences may contain commas.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

/// Escaped, since a bar or a line break would end a cell of a Markdown table.
std::string markdownEscaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '\\' || c == '*' || c == '_' || c == '<' || c == '`') out += '\\';
    out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out;
}

}  // namespace

Cell::Cell(double value, int decimals) {
  std::ostringstream full, rounded;
  full << std::setprecision(10) << value;
  rounded << std::fixed << std::setprecision(decimals) << value;
  exact = full.str();
  shown = rounded.str();
  const bool vanishes = value != 0 && shown.find_first_of("123456789") == std::string::npos;
  if (vanishes) {
    std::ostringstream small;
    small << std::setprecision(2) << value;
    shown = small.str();
  }
}

std::string csvText(const Table& table) {
  std::string out;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    out += (i > 0 ? "," : "") + table.columns[i].name;
  out += '\n';
  for (const std::vector<Cell>& row : table.rows) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const std::string& text = cellAt(row, i).exact;
      out += (i > 0 ? "," : "") + (table.columns[i].isText ? quoted(text) : text);
    }
    out += '\n';
  }
  return out;
}

std::string markdownText(const Table& table) {
  std::string out = "|", rule = "|";
  for (const Column& column : table.columns) {
    out += " " + markdownEscaped(column.name) + " |";
    rule += column.isText ? "---|" : "--:|";
  }
  out += "\n" + rule + "\n";
  for (const std::vector<Cell>& row : table.rows) {
    out += "|";
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      out += " " + markdownEscaped(cellAt(row, i).shown) + " |";
    out += "\n";
  }
  return out;
}

std::string htmlText(const Table& table) {
  const auto opened = [&](const char* tag, std::size_t i) {
    return std::string("<") + tag + (table.columns[i].isText ? ">" : " class=\"number\">");
  };
  std::string out = "<div class=\"table\"><table>\n<thead><tr>";
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    out += opened("th", i) + escapedMarkup(table.columns[i].name) + "</th>";
  out += "</tr></thead>\n<tbody>\n";
  for (const std::vector<Cell>& row : table.rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      out += opened("td", i) + escapedMarkup(cellAt(row, i).shown) + "</td>";
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table></div>\n";
}

}  // namespace abflat::cli
