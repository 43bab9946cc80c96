#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "abflat/status.h"

namespace abflat::test {

/// How a call ended.
struct Ended {
  StatusCode code;
  std::size_t result;  ///< a hash, which needs no memory
};

Ended ended(const Status& status, std::string_view bytes);
Ended ended(const Status& status, const std::vector<double>& numbers);
Ended ended(const Result<std::string>& bytes);
template <class T>
Ended ended(const Result<T>& result, std::vector<double> T::*numbers) {
  return result.ok() ? ended({}, result.value().*numbers) : ended(result.status(), "");
}

/// Calls with memory for ever more allocations, some of them as in a program whose memory is full:
/// each call must report it, leak nothing, and work again once there is memory.
void checkWithLittleMemory(const std::function<Ended()>& call);

/// The most bytes that a call has allocated at one time.
std::size_t mostBytesOf(const std::function<void()>& call);

}  // namespace abflat::test
