#include "io/obj_lines.h"

#include <algorithm>

namespace abflat {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

bool continues(std::string_view physicalLine) {
  const std::size_t last = physicalLine.find_last_not_of("\r\n");
  return last != std::string_view::npos && physicalLine[last] == '\\' &&
         physicalLine.back() == '\n';
}

ObjLine::Kind kindOf(std::string_view keyword) {
  if (keyword == "v") return ObjLine::Kind::Vertex;
  if (keyword == "vt") return ObjLine::Kind::Texcoord;
  if (keyword == "f") return ObjLine::Kind::Face;
  return ObjLine::Kind::Other;
}

}  // namespace

bool ObjLines::next(ObjLine& line) {
  if (rest_.empty()) return false;
  line.number = number_;
  std::size_t end = 0;
  bool more = true;
  while (more && end < rest_.size()) {
    const std::size_t begin = end;
    const std::size_t newline = rest_.find('\n', begin);
    end = newline == std::string_view::npos ? rest_.size() : newline + 1;
    ++number_;
    more = continues(rest_.substr(begin, end - begin));
  }
  line.text = rest_.substr(0, end);
  rest_.remove_prefix(end);

  std::string_view body = line.text.substr(0, line.text.find('#'));
  body.remove_prefix(std::min(body.find_first_not_of(" \t"), body.size()));
  const std::size_t keyword = std::min(body.find_first_of(kBlank), body.size());
  line.kind = kindOf(body.substr(0, keyword));
  body.remove_prefix(keyword);
  const std::size_t last = body.find_last_not_of(kBlank);
  line.arguments = body.substr(0, last == std::string_view::npos ? 0 : last + 1);
  return true;
}

}  // namespace abflat
