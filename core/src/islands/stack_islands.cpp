#include "islands/stack_islands.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/stable_order.h"
#include "exact/orientation.h"
#include "islands/row_spans.h"

namespace abflat {
namespace {

constexpr double kStacked = 0.5;     ///< share of the smaller island
constexpr double kOverlaps = 1e-6;   ///< below are rounding errors
constexpr double kSame = 1 - 1e-12;  ///< share of both islands

/// Whether a point is in a triangle or on its boundary.
bool isIn(const double* p, const double* t) {
  const int turn = orientation(t, t + 2, t + 4);
  if (turn == 0) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (turn * orientation(t + 2 * k, t + 2 * ((k + 1) % 3), p) < 0) return false;
  return true;
}

class IslandStacker {
 public:
  IslandStacker(const IslandTriangles& triangles, const IslandMaterials& materials,
                const Listener& listener)
      : triangles_(triangles),
        materials_(materials),
        listener_(listener),
        stacks_(triangles.islands()),
        copied_(triangles.islands()) {
    for (std::uint32_t i = 0; i < triangles.islands(); ++i) {
      boxes_.push_back(triangles.box(i));
      area_.push_back(spansOf(i, i).area());
      copied_[i] = i;
    }
  }

  /// From left to right, so that each is compared with those that still reach as far.
  IslandStacks run() {
    const std::vector<std::uint32_t> order = stableOrder(
        boxes_.size(),
        [&](std::uint32_t a, std::uint32_t b) { return boxes_[a].low[0] < boxes_[b].low[0]; });
    std::vector<std::uint32_t> open;
    for (const std::uint32_t i : order) {
      const double left = boxes_[i].low[0];
      open.erase(std::remove_if(open.begin(), open.end(),
                                [&](std::uint32_t j) { return boxes_[j].high[0] < left; }),
                 open.end());
      for (const std::uint32_t j : open) {
        if (!listener_.beat()) return {};
        if (boxes_[i].meets(boxes_[j]) && compare(i, j)) {
          copied_[i] = j;
          break;
        }
      }
      // Thousands of copies may lie on each other.
      if (copied_[i] == i) open.push_back(i);
    }
    return result();
  }

 private:
  /// What an island covers of the rows of another.
  RowSpans spansOf(std::uint32_t island, std::uint32_t rows) const {
    RowSpans out(boxes_[rows].low[1], boxes_[rows].high[1]);
    out.cover(triangles_.of(island), triangles_.count(island));
    return out;
  }

  /// Those of different materials have textures of their own.
  bool shareMaterial(std::uint32_t i, std::uint32_t j) const {
    if (materials_.empty()) return true;
    const auto &a = materials_[i], &b = materials_[j];
    return std::any_of(a.begin(), a.end(), [&](std::uint32_t material) {
      return std::binary_search(b.begin(), b.end(), material);
    });
  }

  /// Whether two islands cover the same.
  bool compare(std::uint32_t i, std::uint32_t j) {
    if (area_[i] > area_[j]) std::swap(i, j);
    const bool isSameBox = boxes_[i] == boxes_[j], mayStack = shareMaterial(i, j);
    if (!(area_[i] > 0)) {
      if (!mayStack) return false;
      if (isSameBox || contains(j, i)) stacks_.join(i, j);
      return isSameBox && !(area_[j] > 0);
    }
    if (!isSameBox && stacks_.leastOf(i) == stacks_.leastOf(j)) return false;
    listener_.beat(triangles_.count(i) + triangles_.count(j));
    const double common = commonArea(spansOf(i, i), spansOf(j, i));
    if (mayStack && common >= kStacked * area_[i])
      stacks_.join(i, j);
    else if (common > kOverlaps * area_[i])
      overlaps_.push_back({i, j});
    return mayStack && isSameBox && common >= kSame * area_[j];
  }

  /// Whether all points of `inner` are in triangles of `island`.
  bool contains(std::uint32_t island, std::uint32_t inner) const {
    const double* const end = triangles_.of(island + 1);
    for (const double* p = triangles_.of(inner); p != triangles_.of(inner + 1); p += 2) {
      const double* t = triangles_.of(island);
      while (t != end && !isIn(p, t)) t += 6;
      if (t == end) return false;
    }
    return true;
  }

  IslandStacks result() {
    IslandStacks out;
    out.overlapsOthers.assign(area_.size(), 0);
    for (const auto& [i, j] : overlaps_)
      if (stacks_.leastOf(i) != stacks_.leastOf(j))
        out.overlapsOthers[i] = out.overlapsOthers[j] = 1;
    for (std::uint32_t i = 0; i < area_.size(); ++i) {
      std::uint32_t original = i;
      while (copied_[original] != original) original = copied_[original];
      out.overlapsOthers[i] = out.overlapsOthers[original];
    }
    out.first = std::move(stacks_).release();
    return out;
  }

  const IslandTriangles& triangles_;
  const IslandMaterials& materials_;
  const Listener& listener_;
  DisjointSets stacks_;
  std::vector<UvBox> boxes_;
  std::vector<double> area_;
  std::vector<std::uint32_t>
      copied_;  ///< per island, the one that it covers the same as, or itself
  std::vector<std::array<std::uint32_t, 2>> overlaps_;
};

}  // namespace

IslandStacks stackIslands(const IslandTriangles& triangles, const IslandMaterials& materials,
                          const Listener& listener) {
  return IslandStacker(triangles, materials, listener).run();
}

}  // namespace abflat
