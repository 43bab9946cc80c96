#include "abflat/option_text.h"

#include "base/number_text.h"

namespace abflat {

bool readNumber(std::string_view text, double& value) { return parseDouble(text, value); }

}  // namespace abflat
