#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace abflat {

/// Takes the next word off `text` (separated by blanks and tabs); empty at the end.
std::string_view takeWord(std::string_view& text);

// Texts of numbers are the same in every locale.

/// Correctly rounded; the whole word must be a number ("nan" and "inf" are numbers here). Beyond
/// the range of doubles it is 0 or infinity.
bool parseDouble(std::string_view word, double& value);
bool parseInteger(std::string_view word, std::int64_t& value);

/// The number (without a plus sign) that a text begins with: its end, or nullptr when there is
/// none.
const char* scanDouble(const char* begin, const char* end, double& value);

constexpr std::size_t kMostDoubleChars = 32, kMostIntegerChars = 10;

/// Writes a text of at most kMostDoubleChars with the fewest digits that read back as the same
/// double, and returns its end. The same everywhere.
char* writeDouble(char* out, double value);
/// The same of a finite double, with ".0" where it is whole.
char* writeReal(char* out, double value);
/// The same with at most kMostIntegerChars.
char* writeInteger(char* out, std::uint32_t value);

}  // namespace abflat
