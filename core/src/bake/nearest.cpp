#include "bake/nearest.h"

namespace abflat {
namespace {

std::int64_t squared(std::int64_t x) { return x * x; }

}  // namespace

/// The second pass of Meijster's distance transform: the lower envelope of a parabola per column.
void NearestInRow::find(std::int32_t row, const std::int32_t* rows, std::size_t width) {
  const auto last = static_cast<std::int32_t>(width) - 1;
  const auto height = [&](std::int32_t site) { return squared(rows[site] - row); };
  const auto distance = [&](std::int32_t x, std::int32_t site) {
    return squared(x - site) + height(site);
  };
  sites_.clear();
  begins_.clear();
  for (std::int32_t x = 0; x <= last; ++x) {
    if (rows[x] == kNowhere) continue;
    while (!sites_.empty() &&
           distance(begins_.back(), sites_.back()) > distance(begins_.back(), x)) {
      sites_.pop_back();
      begins_.pop_back();
    }
    std::int64_t begin = 0;
    if (!sites_.empty()) {
      // The last column that is as near to the earlier site, which is not before the site begins.
      const std::int64_t before = sites_.back();
      begin = 1 + (squared(x) - squared(before) + height(x) - height(sites_.back())) /
                      (2 * (x - before));
    }
    if (begin > last) continue;
    sites_.push_back(x);
    begins_.push_back(static_cast<std::int32_t>(begin));
  }
  columns_.assign(width, kNowhere);
  std::size_t end = width;
  for (std::size_t i = sites_.size(); i-- > 0;) {
    const auto begin = static_cast<std::size_t>(begins_[i]);
    for (std::size_t x = begin; x < end; ++x) columns_[x] = sites_[i];
    end = begin;
  }
}

}  // namespace abflat
