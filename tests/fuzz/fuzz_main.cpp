// One target as libFuzzer calls it.

#include "targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  abflat::fuzz::ABFLAT_FUZZ_TARGET(bytes, size);
  return 0;
}
