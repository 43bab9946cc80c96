#include "abflat/peak_memory.h"

#include <cmath>

#if defined(__EMSCRIPTEN__)
#include <emscripten/heap.h>
#elif defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

namespace abflat {

double peakMemory() {
  [[maybe_unused]] constexpr double kMegabyte = 1024.0 * 1024.0;
#if defined(__EMSCRIPTEN__)
  return static_cast<double>(emscripten_get_heap_size()) / kMegabyte;
#elif defined(__unix__) || defined(__APPLE__)
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return std::nan("");
#if defined(__APPLE__)
  constexpr double kUnit = 1;  // bytes
#else
  constexpr double kUnit = 1024;
#endif
  return static_cast<double>(usage.ru_maxrss) * kUnit / kMegabyte;
#else
  return std::nan("");
#endif
}

}  // namespace abflat
