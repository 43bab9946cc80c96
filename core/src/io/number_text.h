#pragma once

#include <cstdint>
#include <string>
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

/// A text that reads back as the same double; the shortest where the standard library can.
void appendDouble(std::string& out, double value);
void appendInteger(std::string& out, std::uint32_t value);

}  // namespace abflat
