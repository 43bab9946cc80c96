#include "chart/chart_set.h"

#include <utility>

#include "chart/chart_order.h"
#include "mesh/topology.h"

namespace abflat {
namespace {

template <class I, class T>
IdVector<I, T> copyOf(IdSpan<I, T> values) {
  return IdVector<I, T>(std::vector<T>(values.begin(), values.end()));
}

}  // namespace

class ChartSetMaker {
 public:
  ChartSetMaker(const PolygonMesh& mesh, const FilledTable& filled)
      : filled_(filled), cut_(filled.table), fans_(findFans(cut_, mesh.vertexCount())) {
    const Components components = findComponents(cut_);
    out_.mesh_ = &mesh;
    out_.parts_.resize(components.firstTriangle.size() + 1);
    out_.ofTriangle.reserve(components.ofTriangle.size());
    for (const ComponentId i : components.ofTriangle)
      out_.ofTriangle.push_back(ChartId(std::uint32_t{i}));
  }

  ChartSet run() {
    listTriangles();
    connect();
    listBoundaries();
    countHoles();
    out_.ofTriangle.resize(filled_.surfaceTriangles);
    return std::move(out_);
  }

 private:
  using Part = ChartSet::Part;

  /// Turns per-chart counts, each stored one chart later, into where the charts begin.
  void addUp(std::uint32_t Part::*number) {
    for (std::size_t i = 1; i < out_.parts_.size(); ++i)
      out_.parts_[i].*number += out_.parts_[i - 1].*number;
  }

  void listTriangles() {
    for (const ChartId chart : out_.ofTriangle) ++out_.parts_[chart + 1].triangle;
    addUp(&Part::triangle);
    IdVector<ChartId, ChartTriangle> next(out_.size(), ChartTriangle(0));
    local_.resize(cut_.triangles().size());
    out_.triangles_.resize(local_.size());
    for (const SurfaceTriangle f : cut_.triangles()) {
      const ChartId chart = out_.ofTriangle[f];
      local_[f] = next[chart];
      ++next[chart];
      out_.triangles_[out_.parts_[chart].triangle + local_[f]] = f;
    }
  }

  /// Numbers vertices chart by chart, within each in the order of the surface's vertices, which is
  /// that of the input's. A vertex of the cut surface belongs to one chart.
  IdVector<SurfaceVertex, ChartVertex> numberVertices() {
    IdVector<SurfaceVertex, ChartId> chart(fans_.inputVertex.size());
    for (const SurfaceTriangle f : cut_.triangles())
      for (const SurfaceCorner c : cornersOf(f)) chart[fans_.ofCorner[c]] = out_.ofTriangle[f];
    for (const ChartId i : chart) ++out_.parts_[i + 1].vertex;
    addUp(&Part::vertex);
    out_.inputVertex_.resize(chart.size());
    IdVector<ChartId, ChartVertex> next(out_.size(), ChartVertex(0));
    IdVector<SurfaceVertex, ChartVertex> number(chart.size());
    for (const SurfaceVertex v : chart.ids()) {
      number[v] = next[chart[v]];
      ++next[chart[v]];
      out_.inputVertex_[out_.parts_[chart[v]].vertex + number[v]] = fans_.inputVertex[v];
    }
    return number;
  }

  void connect() {
    const IdVector<SurfaceVertex, ChartVertex> number = numberVertices();
    out_.vertexOfCorner_.reserve(cut_.twin.size());
    out_.twin_.reserve(cut_.twin.size());
    for (const SurfaceTriangle f : out_.triangles_)
      for (const SurfaceCorner h : cornersOf(f)) {
        out_.vertexOfCorner_.push_back(number[fans_.ofCorner[h]]);
        out_.twin_.push_back(cut_.twin[h].exists() ? inChart(cut_.twin[h]) : ChartCorner());
      }
  }

  void listBoundaries() {
    const std::vector<SurfaceLoop> loops = findBoundaryLoops(cut_);
    const auto chartOf = [&](const SurfaceLoop& loop) {
      return out_.ofTriangle[triangleOf(loop.front())];
    };
    for (const SurfaceLoop& loop : loops)
      out_.parts_[chartOf(loop) + 1].boundary += static_cast<std::uint32_t>(loop.size());
    addUp(&Part::boundary);
    out_.boundary_.resize(out_.parts_.back().boundary);
    // Given islands may have holes.
    IdVector<ChartId, std::uint32_t> written(out_.size(), 0);
    for (const SurfaceLoop& loop : loops) {
      const ChartId chart = chartOf(loop);
      const std::uint32_t begin = out_.parts_[chart].boundary;
      for (const SurfaceCorner h : loop) out_.boundary_[begin + written[chart]++] = inChart(h);
    }
  }

  void countHoles() {
    std::uint32_t last = kNone;  // triangles that fill the same hole are consecutive
    for (std::size_t i = 0; i < filled_.hole.size(); ++i) {
      const SurfaceTriangle f(filled_.surfaceTriangles + i);
      Part& part = out_.parts_[out_.ofTriangle[f]];
      ++part.fillingTriangles;
      part.filledHoles += filled_.hole[i] != last;
      last = filled_.hole[i];
    }
  }

  ChartCorner inChart(SurfaceCorner h) const {
    return cornerOf(local_[triangleOf(h)], placeInTriangle(h));
  }

  const FilledTable& filled_;
  const CornerTable& cut_;
  const Fans fans_;
  IdVector<SurfaceTriangle, ChartTriangle> local_;
  ChartSet out_;
};

ChartTopology ChartSet::topology(ChartId i) const {
  const Part &from = parts_[i], &to = parts_[i + 1];
  const std::size_t corner = 3 * std::size_t{from.triangle};
  const std::size_t triangles = to.triangle - from.triangle;
  return {{vertexOfCorner_.data() + corner, 3 * triangles},
          {twin_.data() + corner, 3 * triangles},
          {boundary_.data() + from.boundary, to.boundary - from.boundary},
          {inputVertex_.data() + from.vertex, to.vertex - from.vertex},
          {triangles_.data() + from.triangle, triangles - from.fillingTriangles},
          from.filledHoles};
}

DiskChart ChartSet::unplaced(ChartId i) const {
  const ChartTopology own = topology(i);
  DiskChart out;
  out.vertexOfCorner = copyOf(own.vertexOfCorner);
  out.twin = copyOf(own.twin);
  out.boundary = copyOf(own.boundary);
  out.inputVertex = copyOf(own.inputVertex);
  out.fillingTriangles = parts_[i].fillingTriangles;
  out.filledHoles = own.filledHoles;
  if (!eliminationRank.empty())
    for (const InputVertex v : own.inputVertex) out.eliminationRank.push_back(eliminationRank[v]);
  return out;
}

DiskChart ChartSet::chart(ChartId i) const {
  DiskChart out = unplaced(i);
  placeChart(*mesh_, out);
  return out;
}

DiskChart ChartSet::chartInOrder(ChartId i, IdVector<ChartVertex, ChartVertex>& former) const {
  DiskChart out = walkedThrough(unplaced(i), former);
  placeChart(*mesh_, out);
  return out;
}

ChartSet makeCharts(const PolygonMesh& mesh, const FilledTable& filled) {
  return ChartSetMaker(mesh, filled).run();
}

}  // namespace abflat
