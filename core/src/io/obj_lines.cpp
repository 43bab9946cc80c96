#include "io/obj_lines.h"

#include <algorithm>

#include "io/text_lines.h"

namespace abflat {
namespace {

constexpr std::string_view kLineEnd = "\r\n";

/// A comment extends to the end of its physical line, even if that is a backslash.
bool continues(std::string_view physicalLine) {
  const std::size_t last = physicalLine.find_last_not_of(kLineEnd);
  return last != std::string_view::npos && physicalLine[last] == '\\' &&
         last + 1 < physicalLine.size() && physicalLine.find('#') == std::string_view::npos;
}

ObjLine::Kind kindOf(std::string_view keyword) {
  if (keyword == "v") return ObjLine::Kind::Vertex;
  if (keyword == "vt") return ObjLine::Kind::Texcoord;
  if (keyword == "f") return ObjLine::Kind::Face;
  if (keyword == "l") return ObjLine::Kind::Polyline;
  return ObjLine::Kind::Other;
}

struct Keyword {
  ObjLine::Kind kind = ObjLine::Kind::Other;
  std::size_t end = 0;  ///< offset in the line
};

Keyword keywordOf(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  const std::size_t end = std::min(line.find_first_of("# \t\r\n", begin), line.size());
  return {kindOf(line.substr(begin, end - begin)), end};
}

std::string_view trimmed(std::string_view text) {
  const std::size_t last = text.find_last_not_of(kBlank);
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

}  // namespace

bool ObjLines::next(ObjLine& line) {
  if (rest_.empty()) return false;
  line.number = number_++;
  line.isJoined = false;
  std::size_t end = lineSize(rest_);
  const Keyword keyword = keywordOf(rest_.substr(0, end));
  line.kind = keyword.kind;
  for (std::size_t last = 0; line.kind != ObjLine::Kind::Other && end < rest_.size();) {
    if (!continues(rest_.substr(last, end - last))) break;
    const std::string_view next = rest_.substr(end, lineSize(rest_.substr(end)));
    if (keywordOf(next).kind != ObjLine::Kind::Other) break;
    line.isJoined = true;
    last = end;
    end += next.size();
    ++number_;
  }

  line.text = rest_.substr(0, end);
  rest_.remove_prefix(end);
  const std::size_t hash = std::min(line.text.find('#'), end);
  line.comment = trimmed(line.text.substr(hash));
  line.arguments = trimmed(line.text.substr(0, hash));
  line.arguments.remove_prefix(std::min(keyword.end, line.arguments.size()));
  // The line was joined with an empty one.
  while (line.isJoined && !line.arguments.empty() && line.arguments.back() == '\\')
    line.arguments = trimmed(line.arguments.substr(0, line.arguments.size() - 1));
  return true;
}

std::string_view argumentsOf(const ObjLine& line, std::string& storage) {
  if (!line.isJoined) return line.arguments;
  storage = line.arguments;
  for (std::size_t i = 0; i < storage.size(); ++i) {
    const bool joins = storage[i] == '\\' && i + 1 < storage.size() &&
                       kLineEnd.find(storage[i + 1]) != std::string_view::npos;
    if (joins || kLineEnd.find(storage[i]) != std::string_view::npos) storage[i] = ' ';
  }
  return storage;
}

}  // namespace abflat
