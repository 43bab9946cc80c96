#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace abflat {

/// Takes the next word off `text` (separated by blanks and tabs); empty at the end.
std::string_view takeWord(std::string_view& text);

/// Correctly rounded; the whole word must be a number ("nan" and "inf" are numbers here).
bool parseDouble(std::string_view word, double& value);
bool parseInteger(std::string_view word, std::int64_t& value);

/// The shortest text that reads back as the same double.
void appendDouble(std::string& out, double value);

}  // namespace abflat
