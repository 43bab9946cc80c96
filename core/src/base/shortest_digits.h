#pragma once

#include <cstddef>

namespace abflat {

/// Buffer size for writeShortest.
constexpr std::size_t kMostShortestChars = 24;

/// Writes a positive, finite double as "d.ddde+7" with the fewest digits that read back as the same
/// value, and returns the end. Among several such texts it is the nearest, so it is the same on
/// every platform.
char* writeShortest(char* out, double value);

}  // namespace abflat
