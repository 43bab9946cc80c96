#pragma once

namespace abflat {

/// Returns freed memory that lies between used blocks to the system. After a stage that takes much,
/// this keeps the memory of later stages from adding to it. Does nothing unless the C library is
/// glibc.
void giveBackFreeMemory();

}  // namespace abflat
