#pragma once

#include <string>
#include <string_view>

#include "abflat/status.h"

namespace abflat {

inline Status parseError(std::string_view fileName, std::size_t line, const std::string& sentence) {
  return {StatusCode::ParseError,
          std::string(fileName) + ":" + std::to_string(line) + ": " + sentence};
}

}  // namespace abflat
