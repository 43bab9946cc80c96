#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "abflat/status.h"

namespace abflat::cli {

constexpr std::string_view kOutOfMemory =
    ": not enough memory. Use a smaller mesh or a machine with more memory";

inline Status outOfMemory(const std::string& place) {
  return {StatusCode::OutOfMemory, place + std::string(kOutOfMemory)};
}

/// Whether a message is that of such a status.
inline bool isOutOfMemory(const std::string& message) {
  return message.find(kOutOfMemory) != std::string::npos;
}

/// Runs `work`, which returns a Result, and names the place where memory ran out, be it in the
/// core, which returns a status, or here, with an exception of the standard library.
template <class Work>
auto orOutOfMemory(const std::string& place, const Work& work) -> decltype(work()) {
  try {
    auto result = work();
    if (result.status().code == StatusCode::OutOfMemory) return outOfMemory(place);
    return result;
  } catch (const std::bad_alloc&) {
    return outOfMemory(place);
  } catch (const std::length_error&) {  // a container that cannot grow to the requested size
    return outOfMemory(place);
  }
}

}  // namespace abflat::cli
