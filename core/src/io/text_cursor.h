#pragma once

#include <cstdint>

namespace abflat {

/// Walks over plain text once, without first looking for the ends of words and lines.
struct TextCursor {
  const char* at;
  const char* end;

  static bool isBlank(char c) { return c == ' ' || c == '\t'; }
  static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }

  bool done() const { return at == end; }
  bool atLineEnd() const { return done() || isLineEnd(*at); }
  bool atWordEnd() const { return atLineEnd() || isBlank(*at); }
  void skipBlanks() {
    while (!done() && isBlank(*at)) ++at;
  }
  void skipWord() {
    while (!atWordEnd()) ++at;
  }
  bool take(char c) {
    if (done() || *at != c) return false;
    ++at;
    return true;
  }
  /// At a line end: "\n", "\r\n" or "\r".
  void takeLineEnd() {
    take('\r');
    take('\n');
  }
};

/// Digits with an optional minus sign; false if there are none, or more than any number needs.
inline bool takeInteger(TextCursor& c, std::int64_t& value) {
  constexpr int kMostDigits = 18;  // always fit std::int64_t
  const bool isNegative = c.take('-');
  const char* const first = c.at;
  std::int64_t size = 0;
  for (; !c.done() && *c.at >= '0' && *c.at <= '9'; ++c.at) {
    if (c.at - first == kMostDigits) return false;
    size = 10 * size + (*c.at - '0');
  }
  value = isNegative ? -size : size;
  return c.at != first;
}

}  // namespace abflat
