#include "base/stable_order.h"

#include <algorithm>
#include <numeric>

namespace abflat {

void sortStably(std::uint32_t* first, std::uint32_t* last, const IsBefore& isBefore) {
  std::stable_sort(first, last, [&](std::uint32_t a, std::uint32_t b) { return isBefore(a, b); });
}

std::vector<std::uint32_t> stableOrder(std::size_t count, const IsBefore& isBefore) {
  std::vector<std::uint32_t> out(count);
  std::iota(out.begin(), out.end(), 0u);
  sortStably(out.data(), out.data() + count, isBefore);
  return out;
}

}  // namespace abflat
