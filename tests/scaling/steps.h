#pragma once

#include <cstdint>

namespace abflat::scaling {

/// Basic blocks of the core that this process has run so far. The same on every machine.
std::uint64_t stepsSoFar();

}  // namespace abflat::scaling
