#include "boundary/carry_along.h"

#include <queue>
#include <utility>

#include "base/portable_math.h"

namespace abflat {
namespace {

/// Moves fall by that much per distance. A map that adds moves of a slope below 1 is one to one.
constexpr double kSlope = 0.2;

/// The vertices that share an edge with each, those of boundary edges once.
class Neighbours {
 public:
  explicit Neighbours(const DiskChart& chart) : begin_(chart.vertexCount() + 1, 0) {
    const auto visit = [&](const auto& pair) {
      for (const ChartCorner h : chart.corners()) {
        const ChartVertex a = chart.vertexOfCorner[h], b = chart.vertexOfCorner[nextCorner(h)];
        pair(a, b);
        if (!chart.twin[h].exists()) pair(b, a);
      }
    };
    visit([&](ChartVertex a, ChartVertex) { ++begin_[a + 1]; });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    of_.resize(begin_.back());
    visit([&](ChartVertex a, ChartVertex b) { of_[next[a]++] = b; });
  }

  template <class Visit>
  void forEach(ChartVertex v, const Visit& visit) const {
    for (std::uint32_t i = begin_[v]; i < begin_[v + 1]; ++i) visit(of_[i]);
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<ChartVertex> of_;
};

}  // namespace

std::vector<double> carriedAlong(const DiskChart& chart, const std::vector<double>& uv,
                                 const IdVector<BoundaryIndex, double>& shift,
                                 const IdVector<BoundaryIndex, Point2>& way) {
  const Neighbours neighbours(chart);
  IdVector<ChartVertex, double> move(chart.vertexCount(), 0);
  IdVector<ChartVertex, BoundaryIndex> carrier(chart.vertexCount());
  // The farthest first; of equals, those of the lowest number.
  std::priority_queue<std::pair<double, std::uint32_t>> open;
  const auto add = [&](ChartVertex v, double length, BoundaryIndex by) {
    if (!(length > move[v])) return;
    move[v] = length;
    carrier[v] = by;
    open.emplace(length, ~std::uint32_t{v});
  };
  for (const BoundaryIndex k : shift.ids()) add(chart.boundaryVertex(k), shift[k], k);
  while (!open.empty()) {
    const double length = open.top().first;
    const ChartVertex v(~open.top().second);
    open.pop();
    if (length < move[v]) continue;
    const Point2 from = pointAt(uv, v);
    neighbours.forEach(v, [&](ChartVertex w) {
      const Point2 to = pointAt(uv, w);
      add(w, length - kSlope * portable::hypot(to[0] - from[0], to[1] - from[1]), carrier[v]);
    });
  }
  std::vector<double> out = uv;
  for (const ChartVertex v : chart.vertices())
    for (std::size_t d = 0; d < 2 && move[v] > 0; ++d)
      out[2 * std::size_t{v} + d] += move[v] * way[carrier[v]][d];
  return out;
}

}  // namespace abflat
