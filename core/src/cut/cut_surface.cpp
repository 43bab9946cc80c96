#include "cut/cut_surface.h"

namespace abflat {
namespace {

/// Whether a seam or the boundary touches a vertex, so that its corners have to be walked around.
IdVector<SurfaceVertex, std::uint8_t> cutVertices(const SeamMesh& mesh, const CutSurface& s) {
  IdVector<SurfaceVertex, std::uint8_t> out(mesh.vertexCount(), 0);
  for (const SurfaceCorner h : s.corners())
    if (!s.twin[h].exists()) out[mesh.tail(h)] = out[mesh.head(h)] = 1;
  return out;
}

void findVertices(const SeamMesh& mesh, CutSurface& s) {
  const IdVector<SurfaceVertex, std::uint8_t> isCut = cutVertices(mesh, s);
  IdVector<SurfaceVertex, OpenVertex> inside(isCut.size());
  s.vertexOfCorner.resize(s.twin.size());
  const auto add = [&](SurfaceCorner outgoing, bool isBoundary, SurfaceVertex meshVertex) {
    s.isBoundary.push_back(isBoundary);
    s.meshVertex.push_back(meshVertex);
    return s.outgoing.push_back(outgoing);
  };
  for (const SurfaceCorner start : s.corners()) {
    const SurfaceVertex v = mesh.vertexOfCorner[start];
    if (!isCut[v]) {
      if (!inside[v].exists()) inside[v] = add(start, false, v);
      s.vertexOfCorner[start] = inside[v];
      continue;
    }
    if (s.vertexOfCorner[start].exists()) continue;
    const OpenVertex id(s.vertexCount());
    SurfaceCorner c = start, first = start;
    do {
      s.vertexOfCorner[c] = id;
      c = rotateCounterClockwise(s.twin, c);
    } while (c.exists() && c != start);
    const bool isOpen = !c.exists();
    // Goes to the corner next to the boundary, on its clockwise side.
    for (c = rotateClockwise(s.twin, start); isOpen && c.exists(); c = rotateClockwise(s.twin, c))
      s.vertexOfCorner[first = c] = id;
    add(first, isOpen, v);
  }
}

void findCharts(CutSurface& s) {
  const IdRange<SurfaceTriangle> triangles(s.twin.size() / 3);
  s.chartOfTriangle.resize(triangles.size());
  s.triangleOrder.resize(triangles.size() + 1);  // a slot for triangles that are not new
  std::uint32_t found = 0;
  for (const SurfaceTriangle start : triangles) {
    if (s.chartOfTriangle[start].exists()) continue;
    const CutChartId id = s.charts.push_back({});
    s.charts.back().firstTriangle = start;
    s.triangleBegin.push_back(found);
    s.chartOfTriangle[start] = id;
    s.triangleOrder[found++] = start;
    for (std::size_t i = s.triangleBegin.back(); i < found; ++i) {
      const SurfaceTriangle triangle = s.triangleOrder[i];
      for (const SurfaceCorner h : cornersOf(triangle)) {
        const SurfaceCorner o = s.twin[h];
        const SurfaceTriangle next = o.exists() ? triangleOf(o) : triangle;
        const bool isNew = !s.chartOfTriangle[next].exists();  // no branch: unpredictable
        s.chartOfTriangle[next] = isNew ? id : s.chartOfTriangle[next];
        s.triangleOrder[found] = next;
        found += isNew;
      }
    }
  }
  s.triangleOrder.pop_back();
  s.triangleBegin.push_back(found);
}

void findLoops(CutSurface& s) {
  IdVector<SurfaceCorner, std::uint8_t> isSeen(s.twin.size(), 0);
  for (const CutChartId c : s.charts.ids()) {
    CutSurface::Chart& chart = s.charts[c];
    chart.firstLoop = LoopId(s.loopBegin.size());
    for (const SurfaceTriangle f : s.trianglesOf(c))
      for (const SurfaceCorner start : cornersOf(f)) {
        if (s.twin[start].exists() || isSeen[start]) continue;
        s.loopBegin.push_back(static_cast<std::uint32_t>(s.loopOrder.size()));
        SurfaceCorner h = start;
        do {
          isSeen[h] = 1;
          s.loopOrder.push_back(h);
          h = nextCorner(h);
          while (s.twin[h].exists()) h = nextCorner(s.twin[h]);
        } while (h != start);
      }
    chart.loops = LoopId(s.loopBegin.size()) - chart.firstLoop;
  }
  s.loopBegin.push_back(static_cast<std::uint32_t>(s.loopOrder.size()));
}

void measureCharts(const SeamMesh& mesh, CutSurface& s) {
  for (const SurfaceTriangle f : mesh.triangles()) {
    CutSurface::Chart& chart = s.charts[s.chartOfTriangle[f]];
    ++chart.triangles;
    chart.area += mesh.area[f];
    for (const SurfaceCorner h : cornersOf(f)) chart.edges += h < s.twin[h];
  }
  for (const OpenVertex v : s.vertices()) ++s.charts[s.chartOf(v)].vertices;
}

}  // namespace

CutSurface cutAlong(const SeamMesh& mesh, const Seams& seams, const Listener& listener) {
  CutSurface s;
  s.twin = mesh.twin;
  for (const SurfaceCorner h : s.corners())
    if (seams[h]) s.twin[h] = SurfaceCorner();
  findVertices(mesh, s);
  listener.beat(mesh.triangleCount());
  findCharts(s);
  listener.beat(mesh.triangleCount());
  findLoops(s);
  listener.beat(mesh.triangleCount());
  measureCharts(mesh, s);
  return s;
}

}  // namespace abflat
