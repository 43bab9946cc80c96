#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace abflat {

using IsBefore = std::function<bool(std::uint32_t, std::uint32_t)>;

/// std::stable_sort of numbers, compiled once for all orders: inlining it for each would add a
/// twentieth to the WebAssembly module.
void sortStably(std::uint32_t* first, std::uint32_t* last, const IsBefore& isBefore);

/// The numbers 0 to `count` - 1 in that order.
std::vector<std::uint32_t> stableOrder(std::size_t count, const IsBefore& isBefore);

/// std::stable_sort of anything, as small as the above: for what is sorted once.
template <class T, class Before>
void sortStably(std::vector<T>& items, Before isBefore) {
  std::vector<T> sorted;
  sorted.reserve(items.size());
  for (const std::uint32_t i : stableOrder(items.size(), [&](std::uint32_t a, std::uint32_t b) {
         return isBefore(items[a], items[b]);
       }))
    sorted.push_back(std::move(items[i]));
  items = std::move(sorted);
}

}  // namespace abflat
