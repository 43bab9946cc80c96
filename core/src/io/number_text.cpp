#include "io/number_text.h"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <version>

namespace abflat {

std::string_view takeWord(std::string_view& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return text = {};
  const std::size_t end = std::min(text.find_first_of(" \t", begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

bool parseInteger(std::string_view word, std::int64_t& value) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  return error == std::errc{} && rest == end && !word.empty();
}

#ifdef __cpp_lib_to_chars

bool parseDouble(std::string_view word, double& value) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc::result_out_of_range && rest == end) {
    value = std::strtod(std::string(word).c_str(),
                        nullptr);  // 0 or infinity, as the sign of the exponent asks
    return true;
  }
  return error == std::errc{} && rest == end && !word.empty();
}

void appendDouble(std::string& out, double value) {
  char text[32];
  out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

#else  // standard libraries without floating point <charconv>

bool parseDouble(std::string_view word, double& value) {
  const std::string text(word);
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return !text.empty() && end == text.c_str() + text.size();
}

void appendDouble(std::string& out, double value) {
  char text[32];
  for (int digits = 15; digits <= 17; ++digits) {
    const int n = std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (digits < 17 && std::strtod(text, nullptr) != value) continue;
    out.append(text, static_cast<std::size_t>(n));
    return;
  }
}

#endif

}  // namespace abflat
