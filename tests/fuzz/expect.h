#pragma once

#include <set>
#include <string>

#include "abflat/status.h"

namespace abflat::fuzz {

/// Ends the process where a property does not hold: that is how a fuzzer takes note of an input.
void expect(bool holds, const std::string& property);

/// Documented reasons to refuse a mesh or options; anything else is a defect.
void expectReason(const Status& status, const std::set<StatusCode>& reasons);

}  // namespace abflat::fuzz
