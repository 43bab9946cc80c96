#pragma once

#include <cstddef>

namespace abflat {

/// Room for what writeShortest writes.
constexpr std::size_t kMostShortestChars = 24;

/// Writes a positive, finite double as "d.ddde+7", by the fewest digits that read back as the same
/// value, and returns the end. Of several such texts the nearest, so it is the same everywhere.
char* writeShortest(char* out, double value);

}  // namespace abflat
