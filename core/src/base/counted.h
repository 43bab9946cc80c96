#pragma once

#include <cstddef>
#include <string>

namespace abflat {

/// "1 edge" or "3 edges".
inline std::string counted(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

}  // namespace abflat
