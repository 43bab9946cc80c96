#include "exact/overlap.h"

#include <algorithm>
#include <cmath>

#include "base/stable_order.h"
#include "exact/orientation.h"

namespace abflat {
namespace {

struct Box {
  double low[2], high[2];

  bool meets(const Box& o) const {
    return low[0] < o.high[0] && o.low[0] < high[0] && low[1] < o.high[1] && o.low[1] < high[1];
  }
};

Box boxOf(const double* t) {
  Box out;
  for (std::size_t d = 0; d < 2; ++d) {
    out.low[d] = std::min({t[d], t[2 + d], t[4 + d]});
    out.high[d] = std::max({t[d], t[2 + d], t[4 + d]});
  }
  return out;
}

/// Whether an edge of `a` has all of `b` on its outer side.
bool isSeparated(const double* a, const double* b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double *from = a + 2 * k, *to = a + 2 * ((k + 1) % 3);
    if (orientation(from, to, b) <= 0 && orientation(from, to, b + 2) <= 0 &&
        orientation(from, to, b + 4) <= 0)
      return true;
  }
  return false;
}

/// Rows about as high as the average triangle.
class Rows {
 public:
  explicit Rows(const std::vector<Box>& boxes) {
    double high = -HUGE_VAL, sum = 0;
    low_ = HUGE_VAL;
    for (const Box& b : boxes) {
      low_ = std::min(low_, b.low[1]);
      high = std::max(high, b.high[1]);
      sum += b.high[1] - b.low[1];
    }
    const auto n = static_cast<double>(boxes.size());
    // One row for what is too large, or too small, to be counted in rows.
    const double count = sum > 0 ? std::clamp(std::floor((high - low_) / sum * n), 1.0, n) : 1;
    const double perUnit = count / (high - low_);
    if (!std::isfinite(sum) || !std::isfinite(perUnit)) return;
    count_ = count;
    perUnit_ = perUnit;
  }

  std::size_t count() const { return static_cast<std::size_t>(count_); }
  std::size_t at(double y) const {
    if (count_ < 2) return 0;
    return static_cast<std::size_t>(std::clamp((y - low_) * perUnit_, 0.0, count_ - 1));
  }

 private:
  double low_ = 0, count_ = 1, perUnit_ = 0;
};

/// Calls `found(i, j)` with pairs of triangles that overlap, until it returns false; leaves out
/// triangles that `isOut`, which `found` may change, and pairs that `mayOverlap`.
template <class IsOut, class MayOverlap, class Found>
void sweep(const std::vector<double>& uv, const IsOut& isOut, const MayOverlap& mayOverlap,
           const Found& found) {
  std::vector<std::uint32_t> order;
  std::vector<Box> boxes;
  for (std::size_t i = 0; 6 * i < uv.size(); ++i) {
    const double* t = &uv[6 * i];
    boxes.push_back(boxOf(t));
    if (orientation(t, t + 2, t + 4) > 0) order.push_back(static_cast<std::uint32_t>(i));
  }
  sortStably(order.data(), order.data() + order.size(),
             [&](std::uint32_t a, std::uint32_t b) { return boxes[a].low[0] < boxes[b].low[0]; });
  const auto at = [&](std::size_t i) { return &uv[6 * i]; };
  // From left to right: any triangle that overlaps the current one is still open in one of its
  // rows.
  const Rows rows(boxes);
  std::vector<std::vector<std::uint32_t>> open(rows.count());
  for (const std::uint32_t i : order)
    for (std::size_t r = rows.at(boxes[i].low[1]); r <= rows.at(boxes[i].high[1]); ++r) {
      std::vector<std::uint32_t>& row = open[r];
      row.erase(std::remove_if(row.begin(), row.end(),
                               [&](std::uint32_t j) {
                                 return isOut(j) || boxes[j].high[0] <= boxes[i].low[0];
                               }),
                row.end());
      for (const std::uint32_t j : row)
        if (!mayOverlap(i, j) && !isOut(i) && !isOut(j) && boxes[i].meets(boxes[j]) &&
            !isSeparated(at(i), at(j)) && !isSeparated(at(j), at(i)))
          if (!found(i, j)) return;
      row.push_back(i);
    }
}

/// Turns triangles counter-clockwise.
void turnAll(std::vector<double>& uv) {
  for (double* t = uv.data(); t != uv.data() + uv.size(); t += 6)
    if (orientation(t, t + 2, t + 4) < 0) std::swap_ranges(t + 2, t + 4, t + 4);
}

/// Per triangle, the first one in the same place; `uv` is counter-clockwise.
std::vector<std::uint32_t> firstCopies(const std::vector<double>& uv) {
  using Points = std::array<std::array<double, 2>, 3>;
  std::vector<Points> points(uv.size() / 6);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) points[i][k] = {uv[6 * i + 2 * k], uv[6 * i + 2 * k + 1]};
    std::sort(points[i].begin(), points[i].end());
  }
  const std::vector<std::uint32_t> order = stableOrder(
      points.size(), [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  std::vector<std::uint32_t> out(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool isCopy = k > 0 && points[order[k]] == points[order[k - 1]];
    out[order[k]] = isCopy ? out[order[k - 1]] : order[k];
  }
  return out;
}

/// Calls `found` with pairs of triangles that overlap, whichever way round they are, but for those
/// that `areKnown`.
template <class Known, class Found>
void sweepAll(std::vector<double>& uv, const Known& areKnown, const Found& found) {
  turnAll(uv);
  // Thousands of copies may lie on each other: the first one stands for them.
  const std::vector<std::uint32_t> first = firstCopies(uv);
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    const double* t = &uv[6 * std::size_t{i}];
    if (first[i] != i && orientation(t, t + 2, t + 4) > 0) found(first[i], i);
  }
  const auto isCopy = [&](std::uint32_t i) { return first[i] != i; };
  sweep(uv, isCopy, areKnown, found);
}

constexpr auto kNoneIsOut = [](std::uint32_t) { return false; };
constexpr auto kNoPair = [](std::uint32_t, std::uint32_t) { return false; };

}  // namespace

std::optional<std::array<std::uint32_t, 2>> findOverlap(const std::vector<double>& uv) {
  std::optional<std::array<std::uint32_t, 2>> out;
  sweep(uv, kNoneIsOut, kNoPair, [&](std::uint32_t i, std::uint32_t j) {
    out = {std::min(i, j), std::max(i, j)};
    return false;
  });
  return out;
}

std::optional<std::array<std::uint32_t, 2>> findOverlapBetween(
    std::vector<double> uv, const std::vector<std::uint32_t>& group) {
  turnAll(uv);
  std::optional<std::array<std::uint32_t, 2>> out;
  const auto areOneGroup = [&](std::uint32_t i, std::uint32_t j) { return group[i] == group[j]; };
  sweep(uv, kNoneIsOut, areOneGroup, [&](std::uint32_t i, std::uint32_t j) {
    out = {std::min(i, j), std::max(i, j)};
    return false;
  });
  return out;
}

std::vector<std::uint8_t> overlappingTriangles(std::vector<double> uv) {
  std::vector<std::uint8_t> out(uv.size() / 6, 0);
  sweepAll(
      uv, [&](std::uint32_t i, std::uint32_t j) { return out[i] && out[j]; },
      [&](std::uint32_t i, std::uint32_t j) {
        out[i] = out[j] = 1;
        return true;
      });
  return out;
}

void forOverlaps(std::vector<double> uv,
                 const std::function<bool(std::uint32_t, std::uint32_t)>& isKnown,
                 const std::function<void(std::uint32_t, std::uint32_t)>& found) {
  sweepAll(uv, isKnown, [&](std::uint32_t i, std::uint32_t j) {
    found(std::min(i, j), std::max(i, j));
    return true;
  });
}

std::vector<std::uint32_t> leaveOutOverlaps(const std::vector<double>& uv,
                                            const std::vector<std::uint32_t>& group,
                                            std::size_t groups) {
  constexpr int kMostRounds = 16;
  std::vector<std::uint32_t> out(groups, kNoOverlap);
  const auto isOut = [&](std::uint32_t i) { return out[group[i]] != kNoOverlap; };
  for (int round = 0; round < kMostRounds; ++round) {
    sweep(uv, isOut, kNoPair, [&](std::uint32_t i, std::uint32_t j) {
      out[std::max(group[i], group[j])] = std::min(group[i], group[j]);
      return true;
    });
    // One that overlaps only what has been left out since may stay after all.
    bool isAny = false;
    for (std::uint32_t g = 0; g < groups && round + 1 < kMostRounds; ++g)
      if (out[g] < g && out[out[g]] != kNoOverlap) {
        out[g] = kNoOverlap;
        isAny = true;
      }
    if (!isAny) break;
  }
  return out;
}

}  // namespace abflat
