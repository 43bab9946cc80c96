#pragma once

#include "abflat/status.h"

#ifdef __cpp_exceptions
#include <new>
#include <stdexcept>
#endif

namespace abflat {

#ifdef __cpp_exceptions
inline Status outOfMemory() {
  try {
    return {StatusCode::OutOfMemory,
            "there is not enough memory. Use a smaller mesh or a machine with more memory"};
  } catch (const std::bad_alloc&) {
    return {StatusCode::OutOfMemory, "out of memory"};  // short enough for the string itself
  }
}
#endif

/// The body of a public function that returns a Result. Lack of memory, which within the library is
/// an exception of the standard library as in any container, ends here as a status. What a caller's
/// own callback throws passes. WebAssembly has no exceptions: the module ends instead.
template <class Work>
auto guarded(const Work& work) -> decltype(work()) {
#ifdef __cpp_exceptions
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return outOfMemory();
  } catch (const std::length_error&) {  // a container that cannot grow to the requested size
    return outOfMemory();
  }
#else
  return work();
#endif
}

}  // namespace abflat
