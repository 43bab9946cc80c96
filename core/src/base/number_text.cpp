#include "base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "base/shortest_digits.h"

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

/// from_chars does not accept a plus sign.
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

bool parseDouble(std::string_view word, double& value) {
  word = withoutPlus(word);
  const char* end = word.data() + word.size();
  return !word.empty() && scanDouble(word.data(), end, value) == end;
}

namespace {

/// 0.digits * 10^point.
struct Decimal {
  std::string_view digits;
  int point;
};

/// Parses a text like "d.ddde+7", and moves the point before the digits.
Decimal takeApart(char* begin, const char* end) {
  const std::string_view text(begin, static_cast<std::size_t>(end - begin));
  const std::size_t e = text.find('e');
  std::int64_t exponent = 0;
  parseInteger(text.substr(e + 1), exponent);
  const bool hasPoint = e > 1;
  if (hasPoint) std::swap(begin[0], begin[1]);
  return {text.substr(0, e).substr(hasPoint ? 1 : 0), static_cast<int>(exponent) + 1};
}

char* append(char* out, std::string_view text) { return std::copy(text.begin(), text.end(), out); }

char* appendPlain(char* out, std::string_view digits, int point) {
  const int count = static_cast<int>(digits.size());
  if (point <= 0) return append(std::fill_n(append(out, "0."), -point, '0'), digits);
  if (count <= point) return append(std::fill_n(append(out, digits), point - count, '0'), ".0");
  out = append(out, digits.substr(0, static_cast<std::size_t>(point)));
  *out++ = '.';
  return append(out, digits.substr(static_cast<std::size_t>(point)));
}

/// The exponent has at least two digits, as printf writes it.
char* appendScientific(char* out, std::string_view digits, int exponent) {
  *out++ = digits[0];
  if (digits.size() > 1) {
    *out++ = '.';
    out = append(out, digits.substr(1));
  }
  *out++ = 'e';
  *out++ = exponent < 0 ? '-' : '+';
  exponent = std::abs(exponent);
  if (exponent < 10) *out++ = '0';
  return std::to_chars(out, out + 3, exponent).ptr;
}

/// The end of a number without ".0".
char* withoutZero(char* begin, char* end) {
  return end - begin > 2 && end[-1] == '0' && end[-2] == '.' ? end - 2 : end;
}

struct Rounded {
  std::string digits;
  int point;
};

/// Half up. Zeros at the end are left out.
Rounded roundedTo(const Decimal& decimal, int digits) {
  const auto kept = static_cast<std::size_t>(digits);
  Rounded out{std::string(decimal.digits.substr(0, kept)), decimal.point};
  if (decimal.digits.size() > kept && decimal.digits[kept] >= '5') {
    std::size_t i = kept;
    while (i > 0 && out.digits[i - 1] == '9') out.digits[--i] = '0';
    if (i > 0)
      ++out.digits[i - 1];
    else
      out = {"1", decimal.point + 1};
  }
  out.digits.resize(out.digits.find_last_not_of('0') + 1);
  return out;
}

constexpr int kLeastPlain = -4;

}  // namespace

char* writeReal(char* out, double value) {
  if (std::signbit(value)) *out++ = '-';
  if (value == 0) return append(out, "0.0");
  std::array<char, kMostShortestChars> text;
  const Decimal decimal = takeApart(text.data(), writeShortest(text.data(), std::abs(value)));
  constexpr int kMostPlain = std::numeric_limits<double>::digits10;
  if (kLeastPlain < decimal.point && decimal.point <= kMostPlain)
    return appendPlain(out, decimal.digits, decimal.point);
  return appendScientific(out, decimal.digits, decimal.point - 1);
}

char* writeDouble(char* out, double value) {
  if (!std::isfinite(value)) {
    const std::string_view text = std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
    return append(out, text);
  }
  return withoutZero(out, writeReal(out, value));
}

std::string withDigits(double value, int digits) {
  std::array<char, kMostDoubleChars> buffer;
  if (value == 0 || !std::isfinite(value))
    return {buffer.data(), writeDouble(buffer.data(), value)};
  std::array<char, kMostShortestChars> text;
  const Decimal decimal = takeApart(text.data(), writeShortest(text.data(), std::abs(value)));
  const Rounded rounded = roundedTo(decimal, digits);
  char* out = buffer.data();
  if (value < 0) *out++ = '-';
  const bool isPlain = kLeastPlain < rounded.point && rounded.point <= digits;
  out = isPlain ? withoutZero(out, appendPlain(out, rounded.digits, rounded.point))
                : appendScientific(out, rounded.digits, rounded.point - 1);
  return {buffer.data(), out};
}

char* writeInteger(char* out, std::uint32_t value) {
  return std::to_chars(out, out + kMostIntegerChars, value).ptr;
}

}  // namespace abflat
