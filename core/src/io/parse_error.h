#pragma once

#include <string>
#include <string_view>

#include "abflat/status.h"

namespace abflat {

inline Status parseError(std::string_view fileName, std::size_t line, const std::string& sentence) {
  return {StatusCode::ParseError,
          std::string(fileName) + ":" + std::to_string(line) + ": " + sentence};
}

/// A word of a file in quotes, for messages. The word may hold any bytes and be of any length.
inline std::string quoted(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string out = "'";
  for (const char c : word.substr(0, kLongest)) out += c > ' ' && c <= '~' ? c : '?';
  return out + (word.size() > kLongest ? "...'" : "'");
}

/// For a word where a number is expected.
inline std::string notANumber(std::string_view word) {
  return quoted(word) + " is not a number" +
         (word.find(',') == std::string_view::npos ? "" : ". Use a decimal point");
}

}  // namespace abflat
