#include "cut/cut_surface.h"

namespace abflat {
namespace {

/// Whether a seam or the boundary touches a vertex, so that its corners have to be walked around.
/// `open`: the half-edges without a twin.
IdVector<SurfaceVertex, std::uint8_t> cutVertices(const SeamMesh& mesh,
                                                  const std::vector<SurfaceCorner>& open) {
  IdVector<SurfaceVertex, std::uint8_t> out(mesh.vertexCount(), 0);
  for (const SurfaceCorner h : open) out[mesh.tail(h)] = out[mesh.head(h)] = 1;
  return out;
}

void findVertices(const SeamMesh& mesh, const std::vector<SurfaceCorner>& open, CutSurface& s) {
  const IdVector<SurfaceVertex, std::uint8_t> isCut = cutVertices(mesh, open);
  IdVector<SurfaceVertex, OpenVertex> inside(isCut.size());
  s.vertexOfCorner.resize(s.twin.size());
  s.outgoing.reserve(mesh.vertexCount());
  s.isBoundary.reserve(mesh.vertexCount());
  s.meshVertex.reserve(mesh.vertexCount());
  const auto add = [&](SurfaceCorner outgoing, bool isBoundary, SurfaceVertex meshVertex) {
    ++s.charts[s.chartOf(outgoing)].vertices;
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

/// Returns the half-edges without a twin, chart by chart.
std::vector<SurfaceCorner> findCharts(CutSurface& s) {
  std::vector<SurfaceCorner> open;
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
        if (!o.exists()) open.push_back(h);
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
  return open;
}

/// `open`: the half-edges without a twin, chart by chart.
void findLoops(const std::vector<SurfaceCorner>& open, CutSurface& s) {
  IdVector<SurfaceCorner, std::uint8_t> isSeen(s.twin.size(), 0);
  s.loopOrder.reserve(open.size());
  auto start = open.begin();
  for (const CutChartId c : s.charts.ids()) {
    CutSurface::Chart& chart = s.charts[c];
    chart.firstLoop = LoopId(s.loopBegin.size());
    for (; start != open.end() && s.chartOf(*start) == c; ++start) {
      if (isSeen[*start]) continue;
      s.loopBegin.push_back(static_cast<std::uint32_t>(s.loopOrder.size()));
      SurfaceCorner h = *start;
      do {
        isSeen[h] = 1;
        s.loopOrder.push_back(h);
        h = nextCorner(h);
        while (s.twin[h].exists()) h = nextCorner(s.twin[h]);
      } while (h != *start);
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
}

}  // namespace

CutSurface cutAlong(const SeamMesh& mesh, const Seams& seams, const Listener& listener) {
  CutSurface s;
  s.twin = mesh.twin;
  for (const SurfaceCorner h : s.corners())
    if (seams[h]) s.twin[h] = SurfaceCorner();
  const std::vector<SurfaceCorner> open = findCharts(s);
  listener.beat(mesh.triangleCount());
  findVertices(mesh, open, s);
  listener.beat(mesh.triangleCount());
  findLoops(open, s);
  listener.beat(mesh.triangleCount());
  measureCharts(mesh, s);
  return s;
}

}  // namespace abflat
