#pragma once

#include <string_view>

#include "abflat/export.h"
#include "abflat/generated/flatten_options.h"
#include "abflat/generated/unwrap_options.h"

namespace abflat {

/// The whole text must be a number, with a point in every locale. "inf" and "nan" count as numbers.
ABFLAT_API bool readNumber(std::string_view text, double& value);

/// Reads a value of the option with this index in optionInfos(), as on the command line: one of its
/// words, a number with or without one of its units ("3G"), or "true" and "false" for a switch.
/// setOption() takes the value and says whether it is in range.
template <class Values>
bool readOption(const Values& values, int index, std::string_view text, double& value,
                bool& isWord) {
  const OptionInfo& option = optionInfos(values)[index];
  isWord = false;
  if (option.isSwitch) {
    value = text == "true" || text == "1";
    return value != 0 || text == "false" || text == "0";
  }
  value = wordValue(values, index, text, isWord);
  if (isWord) return true;
  if (option.isChoice || text.empty()) return false;
  const double unit = unitSize(values, index, text.back());
  if (unit > 0) text.remove_suffix(1);
  if (!readNumber(text, value)) return false;
  if (unit > 0) value *= unit;
  return true;
}

}  // namespace abflat
