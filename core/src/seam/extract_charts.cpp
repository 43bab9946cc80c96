#include "seam/extract_charts.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace abflat {
namespace {

/// Puts a part together, triangle by triangle, then corner by corner.
class PartMaker {
 public:
  explicit PartMaker(const SeamMesh& mesh) : mesh_(mesh), inPart_(mesh.twin.size()) {
    part_.mesh.frontLeeway = mesh.frontLeeway;
  }

  void reserve(std::size_t triangles, std::size_t vertices) {
    SeamMesh& m = part_.mesh;
    m.area.reserve(triangles);
    m.positions.reserve(3 * vertices);
    m.vertexArea.reserve(vertices);
    m.angleSum.reserve(vertices);
    part_.wholeVertex.reserve(vertices);
    part_.wholeHalfEdge.reserve(3 * triangles);
    m.vertexOfCorner.reserve(3 * triangles);
    m.twin.reserve(3 * triangles);
    m.angle.reserve(3 * triangles);
    m.length.reserve(3 * triangles);
    m.cost.reserve(3 * triangles);
    m.weight.reserve(3 * triangles);
  }

  void addTriangle(SurfaceTriangle f) {
    SeamMesh& m = part_.mesh;
    m.area.push_back(mesh_.area[f]);
    if (!mesh_.hole.empty()) m.hole.push_back(mesh_.hole[f]);
    if (!mesh_.front.empty()) m.front.push_back(mesh_.frontAt(f));
    if (!mesh_.excess.empty()) m.excess.push_back(mesh_.excess[f]);
    for (const SurfaceCorner h : cornersOf(f)) inPart_[h] = part_.wholeHalfEdge.push_back(h);
  }

  SurfaceVertex addVertex(SurfaceVertex i) {
    const double* const p = &mesh_.positions[3 * std::size_t{i}];
    part_.mesh.positions.insert(part_.mesh.positions.end(), p, p + 3);
    part_.wholeVertex.push_back(i);
    part_.mesh.angleSum.push_back(0);
    return part_.mesh.vertexArea.push_back(0);
  }

  /// In the order of the triangles. `twin` is in the whole.
  void addCorner(SurfaceCorner h, SurfaceVertex v, SurfaceCorner twin) {
    SeamMesh& m = part_.mesh;
    m.vertexOfCorner.push_back(v);
    m.twin.push_back(twin.exists() ? inPart_[twin] : SurfaceCorner());
    m.angle.push_back(mesh_.angle[h]);
    m.length.push_back(mesh_.length[h]);
    m.cost.push_back(mesh_.cost[h]);
    if (!mesh_.dearness.empty()) m.dearness.push_back(mesh_.dearnessAt(h));
    m.weight.push_back(mesh_.weight[h]);
    m.vertexArea[v] += mesh_.area[triangleOf(h)] / 3;
    m.angleSum[v] += mesh_.angle[h];
  }

  const IdVector<SurfaceCorner, SurfaceCorner>& corners() const { return part_.wholeHalfEdge; }
  SeamPart take() { return std::move(part_); }

 private:
  const SeamMesh& mesh_;
  IdVector<SurfaceCorner, SurfaceCorner> inPart_;
  SeamPart part_;
};

/// Some charts with their slits closed, but for those that are kept.
class ClosedCharts {
 public:
  ClosedCharts(const SeamMesh& mesh, const Seams& seams, const Seams& kept)
      : mesh_(mesh), seams_(seams), kept_(kept), chart_(mesh.triangleCount(), 0) {}

  /// Adds the chart of a triangle.
  void add(SurfaceTriangle first) {
    if (chart_[first] != 0) return;
    const auto chart = static_cast<std::uint32_t>(++charts_);
    std::vector<SurfaceTriangle> open = {first};
    chart_[first] = chart;
    while (!open.empty()) {
      const SurfaceTriangle f = open.back();
      open.pop_back();
      triangles_.push_back(f);
      for (const SurfaceCorner h : cornersOf(f)) {
        const SurfaceCorner o = mesh_.twin[h];
        if (!o.exists() || seams_[h] || chart_[triangleOf(o)] != 0) continue;
        chart_[triangleOf(o)] = chart;
        open.push_back(triangleOf(o));
      }
    }
  }

  SeamPart part() {
    std::sort(triangles_.begin(), triangles_.end());
    PartMaker maker(mesh_);
    for (const SurfaceTriangle f : triangles_) maker.addTriangle(f);
    IdVector<SurfaceCorner, SurfaceVertex> vertex(mesh_.twin.size());
    for (const SurfaceCorner h : maker.corners()) {
      if (!vertex[h].exists()) number(h, maker.addVertex(mesh_.vertexOfCorner[h]), vertex);
      maker.addCorner(h, vertex[h], twinOf(h));
    }
    return maker.take();
  }

 private:
  SurfaceCorner twinOf(SurfaceCorner h) const {
    const SurfaceCorner o = mesh_.twin[h];
    if (!o.exists() || chart_[triangleOf(o)] != chart_[triangleOf(h)]) return {};
    return seams_[h] && h < kept_.size() && kept_[h] ? SurfaceCorner() : o;
  }

  /// All corners around a vertex, of which one is known.
  void number(SurfaceCorner first, SurfaceVertex v,
              IdVector<SurfaceCorner, SurfaceVertex>& vertex) const {
    for (SurfaceCorner h = first; h.exists() && !vertex[h].exists(); h = twinOf(prevCorner(h)))
      vertex[h] = v;
    for (SurfaceCorner o = twinOf(first); o.exists() && !vertex[nextCorner(o)].exists();) {
      const SurfaceCorner h = nextCorner(o);
      vertex[h] = v;
      o = twinOf(h);
    }
  }

  const SeamMesh& mesh_;
  const Seams &seams_, &kept_;
  IdVector<SurfaceTriangle, std::uint32_t> chart_;  ///< from 1 on; 0: not in the part
  std::size_t charts_ = 0;
  std::vector<SurfaceTriangle> triangles_;
};

}  // namespace

SeamPart extractCharts(const SeamMesh& mesh, const CutSurface& s,
                       const IdVector<CutChartId, std::uint8_t>& isWanted,
                       const Listener& listener) {
  PartMaker maker(mesh);
  std::size_t triangles = 0, vertices = 0;
  for (const CutChartId c : s.charts.ids())
    if (isWanted[c]) {
      triangles += s.charts[c].triangles;
      vertices += s.charts[c].vertices;
    }
  maker.reserve(triangles, vertices);
  for (const SurfaceTriangle f : mesh.triangles())
    if (isWanted[s.chartOfTriangle[f]]) maker.addTriangle(f);
  IdVector<OpenVertex, SurfaceVertex> vertex(s.vertexCount());
  for (const SurfaceCorner h : maker.corners()) {
    listener.beat();
    const OpenVertex v = s.vertexOfCorner[h];
    if (!vertex[v].exists()) vertex[v] = maker.addVertex(s.meshVertex[v]);
    maker.addCorner(h, vertex[v], s.twin[h]);
  }
  return maker.take();
}

SeamPart extractClosed(const SeamMesh& mesh, const Seams& seams, const Seams& kept,
                       const std::vector<SurfaceTriangle>& ofCharts) {
  ClosedCharts charts(mesh, seams, kept);
  for (const SurfaceTriangle f : ofCharts) charts.add(f);
  return charts.part();
}

}  // namespace abflat
