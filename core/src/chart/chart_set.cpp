#include "chart/chart_set.h"

#include <algorithm>
#include <utility>

#include "mesh/topology.h"

namespace abflat {
namespace {

/// Vertices of one chart: fans in their order, which is that of the input's vertices.
class VertexNumbers {
 public:
  explicit VertexNumbers(std::size_t fans) : number_(fans, kNone) {}

  std::vector<std::uint32_t> sorted(const std::vector<std::uint32_t>& fans) {
    std::vector<std::uint32_t> out;
    for (const std::uint32_t fan : fans) {
      if (number_[fan] != kNone) continue;
      number_[fan] = 0;
      out.push_back(fan);
    }
    std::sort(out.begin(), out.end());
    for (std::uint32_t i = 0; i < out.size(); ++i) number_[out[i]] = i;
    return out;
  }
  std::uint32_t operator[](std::uint32_t fan) const { return number_[fan]; }

 private:
  std::vector<std::uint32_t> number_;  ///< fans belong to one chart each
};

void countHoles(const FilledTable& filled, const Components& parts, ChartSet& out) {
  std::uint32_t last = kNone;  // triangles that fill a hole follow each other
  for (std::uint32_t i = 0; i < filled.hole.size(); ++i) {
    DiskChart& chart = out.charts[parts.ofTriangle[filled.surfaceTriangles + i]];
    ++chart.fillingTriangles;
    chart.filledHoles += filled.hole[i] != last;
    last = filled.hole[i];
  }
}

}  // namespace

ChartSet makeCharts(const PolygonMesh& mesh, const FilledTable& filled) {
  const CornerTable& cut = filled.table;
  const Fans fans = findFans(cut, mesh.vertexCount());
  Components parts = findComponents(cut);
  ChartSet out;
  const std::size_t count = parts.firstTriangle.size();
  out.charts.resize(count);
  out.triangles.resize(count);
  std::vector<std::uint32_t> local(cut.triangleCount());
  for (std::uint32_t f = 0; f < cut.triangleCount(); ++f) {
    std::vector<std::uint32_t>& own = out.triangles[parts.ofTriangle[f]];
    local[f] = static_cast<std::uint32_t>(own.size());
    own.push_back(f);
  }
  VertexNumbers numbers(fans.inputVertex.size());
  for (std::size_t i = 0; i < count; ++i) {
    DiskChart& chart = out.charts[i];
    for (const std::uint32_t f : out.triangles[i])
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const std::uint32_t twin = cut.twin[h];
        chart.vertexOfCorner.push_back(fans.ofCorner[h]);
        chart.twin.push_back(twin == kNone ? kNone : 3 * local[twin / 3] + twin % 3);
      }
    for (const std::uint32_t fan : numbers.sorted(chart.vertexOfCorner))
      chart.inputVertex.push_back(fans.inputVertex[fan]);
    for (std::uint32_t& v : chart.vertexOfCorner) v = numbers[v];
  }
  for (const std::vector<std::uint32_t>& loop : findBoundaryLoops(cut)) {
    std::vector<std::uint32_t>& boundary = out.charts[parts.ofTriangle[loop.front() / 3]].boundary;
    for (const std::uint32_t h : loop) boundary.push_back(3 * local[h / 3] + h % 3);
  }
  countHoles(filled, parts, out);
  for (std::size_t i = 0; i < count; ++i) {
    out.triangles[i].resize(out.charts[i].surfaceTriangles());
    placeChart(mesh, out.charts[i]);
  }
  out.ofTriangle = std::move(parts.ofTriangle);
  out.ofTriangle.resize(filled.surfaceTriangles);
  return out;
}

}  // namespace abflat
