#pragma once

#include <string>

namespace abflat::cli {

/// Text as HTML and XML take it.
std::string escapedMarkup(const std::string& text);

}  // namespace abflat::cli
