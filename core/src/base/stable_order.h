#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace abflat {

using IsBefore = std::function<bool(std::uint32_t, std::uint32_t)>;

/// std::stable_sort of numbers, compiled once for all orders: inlining it for each would add a
/// twentieth to the WebAssembly module.
void sortStably(std::uint32_t* first, std::uint32_t* last, const IsBefore& isBefore);

/// The numbers 0 to `count` - 1 in that order.
std::vector<std::uint32_t> stableOrder(std::size_t count, const IsBefore& isBefore);

}  // namespace abflat
