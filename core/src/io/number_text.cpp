#include "io/number_text.h"

#include <fast_float/fast_float.h>

#include <charconv>
#include <version>

#ifndef __cpp_lib_to_chars
#include <nlohmann/json.hpp>
#endif

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

void appendDouble(std::string& out, double value) {
  char text[64];
#ifdef __cpp_lib_to_chars
  const char* end = std::to_chars(text, text + sizeof text, value).ptr;
#else
  // Grisu2: reads back as the same double and is nearly always the shortest.
  const char* end = nlohmann::detail::to_chars(text, text + sizeof text, value);
  if (end - text > 2 && end[-1] == '0' && end[-2] == '.') end -= 2;
#endif
  out.append(text, static_cast<std::size_t>(end - text));
}

void appendInteger(std::string& out, std::uint32_t value) {
  char text[10];
  const char* end = std::to_chars(text, text + sizeof text, value).ptr;
  out.append(text, static_cast<std::size_t>(end - text));
}

}  // namespace abflat
