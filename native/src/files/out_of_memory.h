#pragma once

#include <new>
#include <stdexcept>
#include <string>

#include "abflat/status.h"

namespace abflat::cli {

inline Status outOfMemory(const std::string& place) {
  return {StatusCode::OutOfMemory,
          place + ": not enough memory. Use a smaller mesh or a machine with more memory"};
}

/// Runs `work`, which returns a Result, and turns out-of-memory exceptions of the standard library,
/// which the core does not catch, into an error.
template <class Work>
auto orOutOfMemory(const std::string& place, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return outOfMemory(place);
  } catch (const std::length_error&) {  // a container that cannot grow to the requested size
    return outOfMemory(place);
  }
}

}  // namespace abflat::cli
