#include "seam/closed_charts.h"

#include <algorithm>
#include <cstdint>

#include "seam/part_maker.h"

namespace abflat {
namespace {

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

SeamPart extractClosed(const SeamMesh& mesh, const Seams& seams, const Seams& kept,
                       const std::vector<SurfaceTriangle>& ofCharts) {
  ClosedCharts charts(mesh, seams, kept);
  for (const SurfaceTriangle f : ofCharts) charts.add(f);
  return charts.part();
}

}  // namespace abflat
