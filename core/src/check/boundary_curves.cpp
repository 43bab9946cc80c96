#include "check/boundary_curves.h"

#include <algorithm>
#include <array>

#include "base/ids.h"
#include "exact/orientation.h"

namespace abflat {
namespace {

/// An edge of a triangle, stored at the smaller of its two texcoords.
struct EdgeSide {
  std::uint32_t other, chart;
  bool isUp;  ///< runs from the smaller texcoord to the larger
};

class BoundaryFinder {
 public:
  BoundaryFinder(const std::vector<double>& uv, const std::vector<std::uint32_t>& triangles,
                 const std::vector<std::uint32_t>& chartOf,
                 const std::vector<std::uint8_t>& isWanted)
      : uv_(uv),
        triangles_(triangles),
        chartOf_(chartOf),
        isWanted_(isWanted),
        next_(uv.size() / 2, kNone),
        chartOfEdge_(uv.size() / 2, kNone),
        isPinched_(isWanted.size(), 0) {}

  BoundaryCurves run() {
    keepOpenSides();
    for (std::uint32_t p = 0; p < next_.size(); ++p)
      if (next_[p] != kNone && !isPinched_[chartOfEdge_[p]]) walk(p);
    std::sort(out_.broken.begin(), out_.broken.end());
    out_.broken.erase(std::unique(out_.broken.begin(), out_.broken.end()), out_.broken.end());
    return std::move(out_);
  }

 private:
  template <class Use>
  void forSides(const Use& use) const {
    for (std::size_t t = 0; t < chartOf_.size(); ++t) {
      const std::uint32_t* v = &triangles_[3 * t];
      if (chartOf_[t] >= isWanted_.size() || !isWanted_[chartOf_[t]]) continue;
      if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
      for (std::size_t k = 0; k < 3; ++k) use(v[k], v[(k + 1) % 3], chartOf_[t]);
    }
  }

  /// Keeps the edges that have no triangle on their other side.
  void keepOpenSides() {
    std::vector<std::uint32_t> begin(next_.size() + 1, 0);
    forSides([&](std::uint32_t a, std::uint32_t b, std::uint32_t) { ++begin[std::min(a, b) + 1]; });
    for (std::size_t p = 0; p < next_.size(); ++p) begin[p + 1] += begin[p];
    std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
    std::vector<EdgeSide> sides(begin.back());
    forSides([&](std::uint32_t a, std::uint32_t b, std::uint32_t chart) {
      sides[fill[std::min(a, b)]++] = {std::max(a, b), chart, a < b};
    });
    for (std::uint32_t p = 0; p < next_.size(); ++p) {
      const auto first = sides.begin() + begin[p], last = sides.begin() + begin[p + 1];
      std::sort(first, last,
                [](const EdgeSide& a, const EdgeSide& b) { return a.other < b.other; });
      for (auto s = first, end = first; s != last; s = end) {
        int open = 0;
        for (; end != last && end->other == s->other; ++end) open += end->isUp ? 1 : -1;
        if (open == 0) continue;
        if (open == 1 || open == -1)
          addEdge(open > 0 ? p : s->other, open > 0 ? s->other : p, s->chart);
        else
          out_.broken.push_back(s->chart);
      }
    }
  }

  void addEdge(std::uint32_t from, std::uint32_t to, std::uint32_t chart) {
    if (next_[from] != kNone) {
      isPinched_[chartOfEdge_[from]] = isPinched_[chart] = 1;
      out_.arePinched = true;
    }
    next_[from] = to;
    chartOfEdge_[from] = chart;
  }

  /// Takes the curve that begins with this edge.
  void walk(std::uint32_t first) {
    const std::uint32_t chart = chartOfEdge_[first];
    std::vector<std::uint32_t>& corners = corners_;
    corners.clear();
    std::uint32_t p = first;
    do {
      corners.push_back(p);
      const std::uint32_t to = next_[p];
      next_[p] = kNone;
      p = to;
    } while (p != first && next_[p] != kNone);
    if (p != first) return out_.broken.push_back(chart);
    const auto at = [&](std::size_t i) { return &uv_[2 * std::size_t{corners[i]}]; };
    // A triangle without area covers nothing.
    if (corners.size() == 3 && orientation(at(0), at(1), at(2)) == 0) return;
    for (std::size_t i = 0; i < corners.size(); ++i)
      out_.curves.points.insert(out_.curves.points.end(), at(i), at(i) + 2);
    out_.curves.ends.push_back(static_cast<std::uint32_t>(out_.curves.points.size() / 2));
    out_.chart.push_back(chart);
  }

  const std::vector<double>& uv_;
  const std::vector<std::uint32_t>&triangles_, &chartOf_;
  const std::vector<std::uint8_t>& isWanted_;
  std::vector<std::uint32_t> next_;  ///< per texcoord: where the boundary edge that leaves it ends
  std::vector<std::uint32_t> chartOfEdge_;  ///< likewise
  std::vector<std::uint8_t> isPinched_;     ///< per chart
  std::vector<std::uint32_t> corners_;
  BoundaryCurves out_;
};

}  // namespace

BoundaryCurves boundaryCurves(const std::vector<double>& uv,
                              const std::vector<std::uint32_t>& triangles,
                              const std::vector<std::uint32_t>& chartOf,
                              const std::vector<std::uint8_t>& isWanted) {
  return BoundaryFinder(uv, triangles, chartOf, isWanted).run();
}

}  // namespace abflat
