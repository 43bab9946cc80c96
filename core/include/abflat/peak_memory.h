#pragma once

#include "abflat/export.h"

namespace abflat {

/// Peak memory of the process so far, in MB of 2^20 bytes. In WebAssembly it is the size of the
/// heap, which never shrinks. NaN if the system does not tell.
ABFLAT_API double peakMemory();

}  // namespace abflat
