#pragma once

#include <string>

namespace abflat::fuzz {

/// Ends the process where a property does not hold: that is how a fuzzer takes note of an input.
void expect(bool holds, const std::string& property);

}  // namespace abflat::fuzz
