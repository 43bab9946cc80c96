#include "solve/cholesky/large_buffer.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace abflat {
namespace {

constexpr std::size_t kCacheLine = 64;
#if defined(__linux__)
constexpr std::size_t kHugePage = std::size_t{2} << 20;
#endif

}  // namespace

std::size_t largeAlignment([[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  if (bytes >= 2 * kHugePage) return kHugePage;
#endif
  return kCacheLine;
}

void adviseLarge([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  // Only a hint: nothing depends on whether it is followed.
  if (bytes >= 2 * kHugePage) madvise(memory, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
#endif
}

}  // namespace abflat
