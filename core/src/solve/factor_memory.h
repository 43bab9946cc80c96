#pragma once

#include <cstdint>
#include <limits>

namespace abflat {

/// Bytes of a factor and of the matrix.
struct FactorMemory {
  std::uint64_t allowed = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t needed = 0;          ///< in double precision
  std::uint64_t neededInSingle = 0;  ///< in single precision
  bool fits() const { return needed <= allowed; }
  bool fitsInSingle() const { return neededInSingle <= allowed; }
};

}  // namespace abflat
