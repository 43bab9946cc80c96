#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace abflat {

/// Disjoint sets of numbers, with path halving. A set is known by its least number.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : lower_(count) {
    std::iota(lower_.begin(), lower_.end(), 0u);
  }
  /// `lower`: per number, a number of the same set that is not greater.
  explicit DisjointSets(std::vector<std::uint32_t> lower) : lower_(std::move(lower)) {}

  std::uint32_t leastOf(std::uint32_t a) {
    while (lower_[a] != a) a = lower_[a] = lower_[lower_[a]];
    return a;
  }

  /// Joins the sets of two numbers. False if they are one set already.
  bool join(std::uint32_t a, std::uint32_t b) {
    const auto [least, greatest] = std::minmax({leastOf(a), leastOf(b)});
    lower_[greatest] = least;
    return least != greatest;
  }

  /// Per number the least one of its set.
  std::vector<std::uint32_t> release() && {
    for (std::uint32_t a = 0; a < lower_.size(); ++a) lower_[a] = leastOf(a);
    return std::move(lower_);
  }

 private:
  std::vector<std::uint32_t> lower_;
};

}  // namespace abflat
