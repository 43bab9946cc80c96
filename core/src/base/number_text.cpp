#include "base/number_text.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace abflat {

std::string_view takeWord(std::string_view& text) {
  const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
  std::size_t begin = 0;
  while (begin < text.size() && isBlank(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !isBlank(text[end])) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

namespace {

/// from_chars knows no plus sign.
std::string_view withoutPlus(std::string_view number) {
  const bool hasPlus = number.size() > 1 && number[0] == '+' && number[1] != '-';
  return hasPlus ? number.substr(1) : number;
}

}  // namespace

bool parseInteger(std::string_view word, std::int64_t& value) {
  word = withoutPlus(word);
  const char* end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  return error == std::errc{} && rest == end && !word.empty();
}

const char* scanDouble(const char* begin, const char* end, double& value) {
  const auto [rest, error] = fast_float::from_chars(begin, end, value);
  // Out of range: the value is 0 or infinity; older releases do not call that an error.
  return error == std::errc{} || error == std::errc::result_out_of_range ? rest : nullptr;
}

bool parseDouble(std::string_view word, double& value) {
  word = withoutPlus(word);
  const char* end = word.data() + word.size();
  return !word.empty() && scanDouble(word.data(), end, value) == end;
}

char* writeReal(char* out, double value) {
  // Grisu2. Not std::to_chars: Emscripten's library has none for doubles, and native and wasm give
  // the same bytes.
  return nlohmann::detail::to_chars(out, out + kMostDoubleChars, value);
}

char* writeDouble(char* out, double value) {
  if (!std::isfinite(value)) {
    const std::string_view text = std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
    return std::copy(text.begin(), text.end(), out);
  }
  char* const end = writeReal(out, value);
  return end - out > 2 && end[-1] == '0' && end[-2] == '.' ? end - 2 : end;
}

char* writeInteger(char* out, std::uint32_t value) {
  return std::to_chars(out, out + kMostIntegerChars, value).ptr;
}

}  // namespace abflat
