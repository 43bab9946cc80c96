#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace abflat {

/// Takes the next word off `text` (separated by blanks and tabs); empty at the end.
std::string_view takeWord(std::string_view& text);

// Numbers are formatted the same in every locale.

/// Correctly rounded. The whole word must be a number ("nan" and "inf" count as numbers). Beyond
/// the range of doubles the value is 0 or infinity.
bool parseDouble(std::string_view word, double& value);
bool parseInteger(std::string_view word, std::int64_t& value);

/// Parses the number (without a plus sign) at the beginning of a text. Returns its end, or nullptr
/// if there is none.
const char* scanDouble(const char* begin, const char* end, double& value);

constexpr std::size_t kMostDoubleChars = 32, kMostIntegerChars = 10;

/// Writes a double with the fewest digits that read back as the same value, at most
/// kMostDoubleChars characters, and returns the end. The same on every platform.
char* writeDouble(char* out, double value);
/// The same for a finite double, with ".0" if it is an integer.
char* writeReal(char* out, double value);
/// The same for an integer, at most kMostIntegerChars characters.
char* writeInteger(char* out, std::uint32_t value);

/// Rounded to so many significant digits, without zeros at the end, for sentences. With an exponent
/// from 10^digits on and below 10^-4.
std::string withDigits(double value, int digits);

}  // namespace abflat
