#pragma once

namespace abflat {

/// Gives memory that lies free between what is in use back to the system: after a stage that takes
/// much, what the next ones take need not come on top. Where the C library is not glibc nothing
/// happens.
void giveBackFreeMemory();

}  // namespace abflat
