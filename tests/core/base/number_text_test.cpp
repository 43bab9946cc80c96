#include "base/number_text.h"

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "catch.h"

using namespace abflat;

namespace {

std::string textOf(double value) {
  char text[kMostDoubleChars];
  return {text, writeDouble(text, value)};
}

/// The number of digits, without zeros at either end.
int digitsOf(const std::string& text) {
  std::string digits;
  for (const char c : text.substr(0, text.find('e')))
    if (c >= '0' && c <= '9') digits += c;
  const std::size_t first = digits.find_first_not_of('0');
  if (first == std::string::npos) return 0;
  return static_cast<int>(digits.find_last_not_of('0') - first) + 1;
}

}  // namespace

TEST_CASE("doubles survive being written and read") {
  std::mt19937_64 random(1);
  std::vector<double> values{0.0,          -0.0, 1, 0.1, 1e22, 5e-324, 1.7976931348623157e308,
                             123456789.125};
  while (values.size() < 20000) {
    const std::uint64_t bits = random();
    double d;
    std::memcpy(&d, &bits, sizeof d);
    if (std::isfinite(d)) values.push_back(d);
  }
  for (const double d : values) {
    const std::string text = textOf(d);
    double back = 1;
    REQUIRE(parseDouble(text, back));
    CHECK(std::memcmp(&back, &d, sizeof d) == 0);
    CHECK(text.size() <= 24);  // 17 digits, sign, point, "e-308"
    CHECK(std::strtod(text.c_str(), nullptr) == d);
  }
}

TEST_CASE("no text with fewer digits reads back as the same double, and none is nearer") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> sizes(-12, 12), numbers(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    double value = numbers(random) * std::pow(10, sizes(random));
    if (i % 2 == 1) value = static_cast<float>(value);  // these often lie between two texts
    const std::string text = textOf(value);
    const int digits = digitsOf(text);
    char printed[64];
    std::snprintf(printed, sizeof printed, "%.*e", std::max(digits - 1, 0), value);
    INFO(text << " " << printed);
    CHECK(std::strtod(text.c_str(), nullptr) == std::strtod(printed, nullptr));
    if (digits < 2) continue;
    std::snprintf(printed, sizeof printed, "%.*e", digits - 2, value);
    CHECK(std::strtod(printed, nullptr) != value);
  }
}

TEST_CASE("short numbers have short texts, and what is no number has one") {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::pair<double, const char*> cases[] = {{0.1, "0.1"},
                                                  {-0.0, "-0"},
                                                  {1, "1"},
                                                  {-20, "-20"},
                                                  {0.5, "0.5"},
                                                  {100000, "100000"},
                                                  {123456.75, "123456.75"},
                                                  {0.00012, "0.00012"},
                                                  {1e15, "1e+15"},
                                                  {-1.5e-7, "-1.5e-07"},
                                                  {2.5e123, "2.5e+123"},
                                                  {1e22, "1e+22"},
                                                  {1e-5, "1e-05"},
                                                  {1.5, "1.5"},
                                                  {infinity, "inf"},
                                                  {-infinity, "-inf"},
                                                  {std::nan(""), "nan"}};
  for (const auto& [value, text] : cases) CHECK(textOf(value) == text);
  for (const std::uint32_t value : {0u, 7u, 10u, 4294967295u}) {
    char text[kMostIntegerChars];
    CHECK(std::string(text, writeInteger(text, value)) == std::to_string(value));
  }
}

TEST_CASE("texts of any number of digits are read as the nearest double") {
  std::mt19937_64 random(11);
  const auto digits = [&](std::size_t count) {
    std::string out;
    while (out.size() < count) out += static_cast<char>('0' + random() % 10);
    return out;
  };
  const auto check = [](const std::string& text) {
    INFO(text);
    double value = 1;
    REQUIRE(parseDouble(text, value));
    CHECK(value == std::strtod(text.c_str(), nullptr));
  };
  for (int i = 0; i < 40000; ++i) {
    std::string text = (random() % 2 ? "-" : "") + digits(random() % 12);
    if (random() % 4) text += "." + digits(1 + random() % 20);
    if (text.find_first_of("0123456789") == std::string::npos) continue;
    if (random() % 2) text += "e" + std::to_string(static_cast<int>(random() % 60) - 30);
    check(text);
  }
  // Halfway between two doubles, and next to it.
  for (int i = 0; i < 4000; ++i) {
    const std::uint64_t even = (std::uint64_t{1} << 53) + 2 * (random() % 1000000);
    for (const std::uint64_t n : {2 * even + 1, 2 * even + 2, 2 * even + 3}) {
      check(std::to_string(n) + "e" + std::to_string(random() % 4));
      check(std::to_string(n) + ".0000" + digits(random() % 3));
      check(std::to_string(n) + "e-" + std::to_string(random() % 23));
    }
  }
}

TEST_CASE("numbers end where their text does") {
  const std::pair<std::string, std::size_t> cases[] = {
      {"12abc", 2}, {"1.5e", 3},     {"1e+", 1},       {"1e5x", 3},     {"-.5.", 3},   {".e5", 0},
      {"-", 0},     {"infinite", 3}, {"-INFINITY", 9}, {"nan(ind)", 8}, {"nan(-)", 3}, {"na", 0}};
  for (const auto& [text, length] : cases) {
    INFO(text);
    double value = 0;
    const char* const end = scanDouble(text.data(), text.data() + text.size(), value);
    CHECK((end ? static_cast<std::size_t>(end - text.data()) : 0) == length);
  }
}

TEST_CASE("numbers beyond the range of doubles are 0 or infinite, with their sign") {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::string zeros(400, '0');
  const std::pair<std::string, double> cases[] = {{"1.5e-999", 0},
                                                  {"-1.5e-999", -0.0},
                                                  {"1.5e999", infinity},
                                                  {"-1e999", -infinity},
                                                  {"0." + zeros + "1", 0},
                                                  {"1" + zeros, infinity},
                                                  {"1" + zeros + "e-9", infinity},
                                                  {"0." + zeros + "1e9", 0},
                                                  {"1e99999999999999999999", infinity},
                                                  {"1e-99999999999999999999", 0}};
  for (const auto& [text, wanted] : cases) {
    INFO(text);
    double value = 1;
    CHECK(parseDouble(text, value));
    CHECK(value == wanted);
    CHECK(std::signbit(value) == std::signbit(wanted));
  }
}

TEST_CASE("numbers are read and written alike in every locale") {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  bool hasComma = false;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8"})
    hasComma = hasComma || std::setlocale(LC_ALL, name) != nullptr;
  if (!hasComma) WARN("skipped: no locale with a decimal comma is installed");
  double half = 1, tiny = 1, comma = 1;
  const bool isRead = parseDouble("0.5", half) && parseDouble("2.5e-999", tiny);
  const bool isCommaRead = parseDouble("0,5", comma);
  const std::string text = textOf(0.1);
  std::setlocale(LC_ALL, before.c_str());
  CHECK(isRead);
  CHECK(half == 0.5);
  CHECK(tiny == 0);
  CHECK_FALSE(isCommaRead);
  CHECK(text == "0.1");
}

TEST_CASE("only decimal numbers are numbers") {
  double value = 0;
  std::int64_t integer = 0;
  for (const char* word : {"", "+", "-", "+-1", "--1", "1.5x", "0x10", "1e", ".", "1 ", "\v1"}) {
    INFO(word);
    CHECK_FALSE(parseDouble(word, value));
    CHECK_FALSE(parseInteger(word, integer));
  }
  for (const char* word : {"+1", "1.", "1e0", "10E-1", "0001.0"}) {
    CHECK(parseDouble(word, value));
    CHECK(value == 1);
  }
}

TEST_CASE("numbers in sentences are rounded as printf rounds them") {
  CHECK(withDigits(0, 3) == "0");
  CHECK(withDigits(-12.25, 6) == "-12.25");
  CHECK(withDigits(0.99996, 3) == "1");
  CHECK(withDigits(9996, 3) == "1e+04");
  CHECK(withDigits(100, 3) == "100");
  CHECK(withDigits(0.0001, 2) == "0.0001");
  CHECK(withDigits(0.00001, 2) == "1e-05");
  CHECK(withDigits(HUGE_VAL, 2) == "inf");
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(-10, 10);
  for (int i = 0; i < 20000; ++i) {
    const int exponent = static_cast<int>(random() % 40) - 20, digits = 1 + i % 17;
    const double value = mantissa(random) * std::pow(10.0, exponent);
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    INFO(text << " of " << textOf(value));
    const std::string ours = withDigits(value, digits);
    // The shortest text that reads back as the same value is rounded, not the value itself.
    if (digits < 13)
      CHECK(ours == text);
    else
      CHECK(std::abs(std::stod(ours) - value) <= std::abs(value) * std::pow(10.0, 1 - digits));
  }
}
