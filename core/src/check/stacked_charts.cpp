#include "check/stacked_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "base/stable_order.h"
#include "exact/orientation.h"

namespace abflat {
namespace {

using UvBox = std::array<double, 4>;
using Edge = std::array<double, 4>;  ///< from one point to another

/// The edges of an outline, sorted.
using Outline = std::vector<Edge>;

class StackFinder {
 public:
  StackFinder(const std::vector<double>& uv, const std::vector<std::uint32_t>& triangles,
              const std::vector<std::uint32_t>& chartOf, std::size_t charts)
      : uv_(uv), triangles_(triangles), chartOf_(chartOf), sameBox_(charts, 0), sign_(charts, 0) {
    groupBoxes();
    begin_.assign(charts + 1, 0);
    for (const std::uint32_t c : chartOf_)
      if (isGrouped(c)) ++begin_[c + 1];
    for (std::size_t c = 0; c < charts; ++c) begin_[c + 1] += begin_[c];
    ofChart_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t t = 0; t < chartOf_.size(); ++t)
      if (isGrouped(chartOf_[t])) ofChart_[next[chartOf_[t]]++] = t;
  }

  std::vector<StackedChart> run(bool mayMirror) {
    std::vector<Outline> outline(sameBox_.size());
    std::vector<std::uint32_t> order;
    for (std::uint32_t c = 0; c < sameBox_.size(); ++c) {
      if (!sameBox_[c] || (sign_[c] = signOf(c)) == 0) continue;
      outline[c] = outlineOf(c);
      order.push_back(c);
    }
    sort(order, [&](std::uint32_t a, std::uint32_t b) { return outline[a] < outline[b]; });
    std::vector<StackedChart> out(sameBox_.size());
    for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
      std::uint32_t base = kOnNone;
      for (end = i; end < order.size() && outline[order[end]] == outline[order[i]]; ++end)
        if (base == kOnNone && sign_[order[end]] > 0) base = order[end];
      for (std::size_t k = i; k < end && base != kOnNone; ++k)
        if (const std::uint32_t c = order[k]; c != base && (sign_[c] > 0 || mayMirror))
          out[c] = {base, sign_[c] < 0};
    }
    return out;
  }

 private:
  static void sort(std::vector<std::uint32_t>& charts, const IsBefore& isBefore) {
    sortStably(charts.data(), charts.data() + charts.size(), isBefore);
  }
  bool isGrouped(std::uint32_t chart) const { return chart < sameBox_.size() && sameBox_[chart]; }
  const double* at(std::uint32_t v) const { return &uv_[2 * std::size_t{v}]; }
  bool isEmpty(std::size_t t) const {
    const std::uint32_t* v = &triangles_[3 * t];
    return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
  }

  /// Marks charts with the same box as another one.
  void groupBoxes() {
    std::vector<UvBox> boxes(sameBox_.size(), {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL});
    for (std::size_t t = 0; t < chartOf_.size(); ++t) {
      if (chartOf_[t] >= boxes.size() || isEmpty(t)) continue;
      UvBox& box = boxes[chartOf_[t]];
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t d = 0; d < 2; ++d) {
          const double x = at(triangles_[3 * t + k])[d];
          box[d] = std::min(box[d], x);
          box[2 + d] = std::max(box[2 + d], x);
        }
    }
    std::vector<std::uint32_t> order;
    for (std::uint32_t c = 0; c < boxes.size(); ++c)
      if (boxes[c][0] <= boxes[c][2]) order.push_back(c);
    sort(order, [&](std::uint32_t a, std::uint32_t b) { return boxes[a] < boxes[b]; });
    for (std::size_t i = 1; i < order.size(); ++i)
      if (boxes[order[i]] == boxes[order[i - 1]]) sameBox_[order[i]] = sameBox_[order[i - 1]] = 1;
  }

  /// Whether the chart's triangles run counter-clockwise (1) or clockwise (-1); 0 if none has area.
  int signOf(std::uint32_t chart) const {
    for (std::uint32_t i = begin_[chart]; i < begin_[chart + 1]; ++i) {
      const std::uint32_t* v = &triangles_[3 * std::size_t{ofChart_[i]}];
      if (const int sign = orientation(at(v[0]), at(v[1]), at(v[2])); sign != 0) return sign;
    }
    return 0;
  }

  /// As if it ran counter-clockwise. Edges in opposite directions cancel, so two charts with the
  /// same outline cover each place equally often.
  Outline outlineOf(std::uint32_t chart) const {
    std::vector<Edge> sides;
    for (std::uint32_t i = begin_[chart]; i < begin_[chart + 1]; ++i) {
      const std::uint32_t* v = &triangles_[3 * std::size_t{ofChart_[i]}];
      for (std::size_t k = 0; k < 3; ++k) {
        const double *a = at(v[k]), *b = at(v[(k + 1) % 3]);
        if (sign_[chart] < 0) std::swap(a, b);
        sides.push_back({a[0], a[1], b[0], b[1]});
      }
    }
    sortStably(sides, std::less<>());
    Outline out;
    for (auto first = sides.begin(); first != sides.end();) {
      const auto last = std::upper_bound(first, sides.end(), *first);
      const Edge& e = *first;
      const auto back = std::equal_range(sides.begin(), sides.end(), Edge{e[2], e[3], e[0], e[1]});
      for (auto more = (last - first) - (back.second - back.first); more > 0; --more)
        out.push_back(e);
      first = last;
    }
    return out;
  }

  const std::vector<double>& uv_;
  const std::vector<std::uint32_t>&triangles_, &chartOf_;
  std::vector<std::uint8_t> sameBox_;  ///< per chart, whether another one has the same box
  std::vector<int> sign_;
  std::vector<std::uint32_t> begin_, ofChart_;  ///< triangles by chart, of those in `sameBox_`
};

}  // namespace

std::vector<StackedChart> findStackedCharts(const std::vector<double>& uv,
                                            const std::vector<std::uint32_t>& triangles,
                                            const std::vector<std::uint32_t>& chartOf,
                                            std::size_t charts, bool mayMirror) {
  return StackFinder(uv, triangles, chartOf, charts).run(mayMirror);
}

}  // namespace abflat
