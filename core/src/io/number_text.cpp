#include "io/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <version>

#ifndef __cpp_lib_to_chars
#include <clocale>
#include <cstdio>
#include <cstdlib>
#endif

namespace abflat {

std::string_view takeWord(std::string_view& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return text = {};
  const std::size_t end = std::min(text.find_first_of(" \t", begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

namespace {

/// std::from_chars knows no plus sign.
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

#ifdef __cpp_lib_to_chars

namespace {

/// 0 or infinity for a decimal that no double can hold. Not strtod: it follows the locale.
double outOfRangeValue(std::string_view decimal) {
  const std::size_t e = std::min(decimal.find_first_of("eE"), decimal.size());
  const std::string_view mantissa = decimal.substr(0, e);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t leading = std::min(mantissa.find_first_of("123456789"), mantissa.size());
  const std::string_view written = decimal.substr(std::min(e + 1, decimal.size()));
  std::int64_t exponent = 0;
  bool isTiny = !written.empty() && written.front() == '-';
  if (written.empty() || parseInteger(written, exponent))
    isTiny = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(leading) + exponent < 0;
  const double size = isTiny ? 0 : std::numeric_limits<double>::infinity();
  return decimal.front() == '-' ? -size : size;
}

}  // namespace

bool parseDouble(std::string_view word, double& value) {
  word = withoutPlus(word);
  const char* end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  if (rest != end || word.empty()) return false;
  if (error == std::errc::result_out_of_range) value = outOfRangeValue(word);
  return error == std::errc{} || error == std::errc::result_out_of_range;
}

void appendDouble(std::string& out, double value) {
  char text[32];
  out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

#else  // standard libraries without floating point <charconv>

namespace {

/// strtod and snprintf follow the locale that the process has chosen; meshes do not.
char decimalPoint() { return *std::localeconv()->decimal_point; }

}  // namespace

bool parseDouble(std::string_view word, double& value) {
  // strtod would also take white space and hexadecimal numbers.
  if (word.empty() || word.find_first_of(" \t\v\f\r\nxX,") != std::string_view::npos) return false;
  std::string text(word);
  std::replace(text.begin(), text.end(), '.', decimalPoint());
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return end == text.c_str() + text.size();
}

void appendDouble(std::string& out, double value) {
  char text[32];
  for (int digits = 15; digits <= 17; ++digits) {
    const int size = std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (digits < 17 && std::strtod(text, nullptr) != value) continue;
    std::replace(text, text + size, decimalPoint(), '.');
    out.append(text, static_cast<std::size_t>(size));
    return;
  }
}

#endif

}  // namespace abflat
