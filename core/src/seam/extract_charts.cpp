#include "seam/extract_charts.h"

#include "seam/part_maker.h"

namespace abflat {

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

}  // namespace abflat
