#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace abflat::bindings {

/// A buffer of `size` numbers for JavaScript to fill.
template <class T>
T* resized(std::vector<T>& numbers, std::size_t size) {
  numbers.resize(size);
  return numbers.data();
}
template <class T, std::size_t N>
T* resized(std::vector<std::array<T, N>>& groups, std::size_t size) {
  groups.resize(size / N);
  return groups.empty() ? nullptr : groups.front().data();
}

}  // namespace abflat::bindings
