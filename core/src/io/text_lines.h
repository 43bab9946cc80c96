#pragma once

#include <cstddef>
#include <cstring>
#include <string_view>

namespace abflat {

/// UTF-8 files may begin with this; it is not part of their first line.
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

constexpr std::string_view kBlank = " \t\r\n";

inline bool hasByteOrderMark(std::string_view text) {
  return text.substr(0, kByteOrderMark.size()) == kByteOrderMark;
}

template <std::size_t N>
bool beginsWith(std::string_view text, const char (&word)[N]) {
  return text.size() >= N - 1 && std::memcmp(text.data(), word, N - 1) == 0;
}

/// Recognises a byte order mark or, without one, a text whose first characters are ASCII.
inline bool isUtf16(std::string_view text) {
  if (beginsWith(text, "\xFF\xFE") || beginsWith(text, "\xFE\xFF")) return true;
  if (text.size() < 4 || (text[0] == 0) == (text[1] == 0)) return false;
  return (text[0] == 0) == (text[2] == 0) && (text[1] == 0) == (text[3] == 0);
}

/// Size of the first line including its end, which is "\n", "\r\n", "\r" or the end of the text.
inline std::size_t lineSize(std::string_view text) {
  const char *begin = text.data(), *end = begin + text.size(), *at = begin;
  while (at != end && *at != '\n' && *at != '\r') ++at;
  if (at == end) return text.size();
  const bool isPair = *at == '\r' && at + 1 != end && at[1] == '\n';
  return static_cast<std::size_t>(at - begin) + (isPair ? 2 : 1);
}

/// The line end of a line that includes it: "\n", "\r\n", "\r" or nothing.
inline std::string_view lineEnd(std::string_view line) {
  if (line.empty() || (line.back() != '\n' && line.back() != '\r')) return {};
  const bool isPair = line.size() > 1 && line.substr(line.size() - 2) == "\r\n";
  return line.substr(line.size() - (isPair ? 2 : 1));
}

/// What follows a keyword, trimmed of blanks; a name may contain some.
inline std::string_view restOfLine(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(kBlank) + 1 - begin);
}

}  // namespace abflat
