#pragma once

#include <string>
#include <utility>

#include "abflat/status.h"

namespace abflat {

/// What is asked for cannot be done.
inline Status invalid(std::string text) { return {StatusCode::InvalidOption, std::move(text)}; }

}  // namespace abflat
