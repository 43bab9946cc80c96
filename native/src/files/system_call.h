#pragma once

#include <cerrno>

namespace abflat::cli {

/// Repeats a system call that a signal has interrupted, but not for ever, so that a broken file
/// system cannot hang the program.
template <class Call>
auto uninterrupted(const Call& call) -> decltype(call()) {
  constexpr int kMostTries = 1000;
  auto result = call();
  for (int i = 1; result < 0 && errno == EINTR && i < kMostTries; ++i) result = call();
  return result;
}

}  // namespace abflat::cli
