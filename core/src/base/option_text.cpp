#include "abflat/option_text.h"

#include <cmath>

#include "abflat/atlas_size.h"
#include "base/number_text.h"

namespace abflat {

bool readNumber(std::string_view text, double& value) { return parseDouble(text, value); }

double atlasSizeValue(std::string_view text, bool& found) {
  const std::size_t at = text.find_first_of("xX");
  found = at != std::string_view::npos;
  if (!found) return 0;
  constexpr double kNoSize = -1;
  double sides[2];
  std::string_view parts[] = {text.substr(0, at), text.substr(at + 1)};
  for (std::size_t d = 0; d < 2; ++d) {
    while (!parts[d].empty() && parts[d].front() == ' ') parts[d].remove_prefix(1);
    while (!parts[d].empty() && parts[d].back() == ' ') parts[d].remove_suffix(1);
    if (!parseDouble(parts[d], sides[d]) || sides[d] != std::floor(sides[d]) || sides[d] < 1 ||
        sides[d] >= kHeightUnit)
      return kNoSize;
  }
  return sides[0] + sides[1] * kHeightUnit;
}

}  // namespace abflat
