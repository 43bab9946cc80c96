#include "seam/extract_charts.h"

namespace abflat {
namespace {

void reserve(SeamPart& part, std::size_t triangles, std::size_t vertices) {
  SeamMesh& m = part.mesh;
  m.area.reserve(triangles);
  m.positions.reserve(3 * vertices);
  m.vertexArea.reserve(vertices);
  m.angleSum.reserve(vertices);
  part.wholeVertex.reserve(vertices);
  part.wholeHalfEdge.reserve(3 * triangles);
  m.vertexOfCorner.reserve(3 * triangles);
  m.twin.reserve(3 * triangles);
  m.angle.reserve(3 * triangles);
  m.length.reserve(3 * triangles);
  m.cost.reserve(3 * triangles);
  m.weight.reserve(3 * triangles);
}

}  // namespace

SeamPart extractCharts(const SeamMesh& mesh, const CutSurface& s,
                       const IdVector<CutChartId, std::uint8_t>& isWanted,
                       const Listener& listener) {
  SeamPart part;
  SeamMesh& m = part.mesh;
  std::size_t triangles = 0, vertices = 0;
  for (const CutChartId c : s.charts.ids())
    if (isWanted[c]) {
      triangles += s.charts[c].triangles;
      vertices += s.charts[c].vertices;
    }
  reserve(part, triangles, vertices);
  m.frontLeeway = mesh.frontLeeway;
  IdVector<OpenVertex, SurfaceVertex> vertex(s.vertexCount());
  IdVector<SurfaceCorner, SurfaceCorner> inPart(s.twin.size());
  for (const SurfaceTriangle f : mesh.triangles()) {
    if (!isWanted[s.chartOfTriangle[f]]) continue;
    m.area.push_back(mesh.area[f]);
    if (!mesh.hole.empty()) m.hole.push_back(mesh.hole[f]);
    if (!mesh.front.empty()) m.front.push_back(mesh.frontAt(f));
    if (!mesh.excess.empty()) m.excess.push_back(mesh.excess[f]);
    for (const SurfaceCorner h : cornersOf(f)) inPart[h] = part.wholeHalfEdge.push_back(h);
  }
  for (const SurfaceCorner h : part.wholeHalfEdge) {
    listener.beat();
    const OpenVertex v = s.vertexOfCorner[h];
    const SurfaceVertex i = s.meshVertex[v];
    if (!vertex[v].exists()) {
      const double* const p = &mesh.positions[3 * std::size_t{i}];
      m.positions.insert(m.positions.end(), p, p + 3);
      part.wholeVertex.push_back(i);
      vertex[v] = m.vertexArea.push_back(0);
      m.angleSum.push_back(0);
    }
    m.vertexOfCorner.push_back(vertex[v]);
    m.twin.push_back(s.twin[h].exists() ? inPart[s.twin[h]] : SurfaceCorner());
    m.angle.push_back(mesh.angle[h]);
    m.length.push_back(mesh.length[h]);
    m.cost.push_back(mesh.cost[h]);
    if (!mesh.dearness.empty()) m.dearness.push_back(mesh.dearnessAt(h));
    m.weight.push_back(mesh.weight[h]);
    m.vertexArea[vertex[v]] += mesh.area[triangleOf(h)] / 3;
    m.angleSum[vertex[v]] += mesh.angle[h];
  }
  return part;
}

}  // namespace abflat
