#pragma once

namespace abflat {

/// The most memory that the process has held so far, in MB of 2^20 bytes; in WebAssembly its heap,
/// which never shrinks. NaN where the system does not tell.
double peakMemory();

}  // namespace abflat
