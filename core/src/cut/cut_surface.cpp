#include "cut/cut_surface.h"

#include <algorithm>

namespace abflat {
namespace {

/// Per vertex of the mesh, whether its corners are to be walked round: a seam or the boundary comes
/// to it.
std::vector<std::uint8_t> openVertices(const SeamMesh& mesh, const CutSurface& s) {
  std::vector<std::uint8_t> out(mesh.vertexCount(), 0);
  for (std::uint32_t h = 0; h < s.twin.size(); ++h)
    if (s.twin[h] == kNone)
      out[mesh.vertexOfCorner[h]] = out[mesh.vertexOfCorner[nextCorner(h)]] = 1;
  return out;
}

void findVertices(const SeamMesh& mesh, CutSurface& s) {
  const auto corners = static_cast<std::uint32_t>(s.twin.size());
  const std::vector<std::uint8_t> isOpenVertex = openVertices(mesh, s);
  std::vector<std::uint32_t> inside(isOpenVertex.size(), kNone);
  s.vertexOfCorner.assign(corners, kNone);
  const auto add = [&](std::uint32_t outgoing, bool isBoundary, std::uint32_t meshVertex) {
    s.outgoing.push_back(outgoing);
    s.isBoundary.push_back(isBoundary);
    s.meshVertex.push_back(meshVertex);
    return s.vertexCount() - 1;
  };
  for (std::uint32_t start = 0; start < corners; ++start) {
    const std::uint32_t v = mesh.vertexOfCorner[start];
    if (!isOpenVertex[v]) {
      if (inside[v] == kNone) inside[v] = add(start, false, v);
      s.vertexOfCorner[start] = inside[v];
      continue;
    }
    if (s.vertexOfCorner[start] != kNone) continue;
    const std::uint32_t id = s.vertexCount();
    std::uint32_t c = start, first = start;
    do {
      s.vertexOfCorner[c] = id;
      c = rotateCounterClockwise(s.twin, c);
    } while (c != kNone && c != start);
    const bool isOpen = c == kNone;
    // To the corner beside the boundary on its clockwise side.
    for (c = rotateClockwise(s.twin, start); isOpen && c != kNone; c = rotateClockwise(s.twin, c))
      s.vertexOfCorner[first = c] = id;
    add(first, isOpen, v);
  }
}

void findCharts(CutSurface& s) {
  const auto triangles = static_cast<std::uint32_t>(s.twin.size() / 3);
  s.chartOfTriangle.assign(triangles, kNone);
  s.triangleOrder.resize(triangles + std::size_t{1});  // a place to write what is not new
  std::uint32_t found = 0;
  for (std::uint32_t start = 0; start < triangles; ++start) {
    if (s.chartOfTriangle[start] != kNone) continue;
    const auto id = static_cast<std::uint32_t>(s.charts.size());
    s.charts.emplace_back();
    s.charts.back().firstTriangle = start;
    s.triangleBegin.push_back(found);
    s.chartOfTriangle[start] = id;
    s.triangleOrder[found++] = start;
    for (std::size_t i = s.triangleBegin.back(); i < found; ++i) {
      const std::uint32_t triangle = s.triangleOrder[i];
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t o = s.twin[3 * triangle + k];
        const std::uint32_t next = o == kNone ? triangle : o / 3;
        const bool isNew = s.chartOfTriangle[next] == kNone;  // no branch: nobody could guess it
        s.chartOfTriangle[next] = isNew ? id : s.chartOfTriangle[next];
        s.triangleOrder[found] = next;
        found += isNew;
      }
    }
  }
  s.triangleOrder.pop_back();
  s.triangleBegin.push_back(triangles);
}

void findLoops(CutSurface& s) {
  std::vector<std::uint8_t> isSeen(s.twin.size(), 0);
  for (std::uint32_t c = 0; c < s.charts.size(); ++c) {
    s.charts[c].firstLoop = static_cast<std::uint32_t>(s.loopBegin.size());
    for (std::uint32_t i = s.triangleBegin[c]; i < s.triangleBegin[c + 1]; ++i)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t start = 3 * s.triangleOrder[i] + k;
        if (s.twin[start] != kNone || isSeen[start]) continue;
        s.loopBegin.push_back(static_cast<std::uint32_t>(s.loopOrder.size()));
        std::uint32_t h = start;
        do {
          isSeen[h] = 1;
          s.loopOrder.push_back(h);
          h = nextCorner(h);
          while (s.twin[h] != kNone) h = nextCorner(s.twin[h]);
        } while (h != start);
      }
    s.charts[c].loops = static_cast<std::uint32_t>(s.loopBegin.size()) - s.charts[c].firstLoop;
  }
  s.loopBegin.push_back(static_cast<std::uint32_t>(s.loopOrder.size()));
}

}  // namespace

CutSurface cutAlong(const SeamMesh& mesh, const Seams& seams, const Pulse& pulse) {
  CutSurface s;
  s.twin = mesh.twin;
  for (std::size_t h = 0; h < s.twin.size(); ++h)
    if (seams[h]) s.twin[h] = kNone;
  findVertices(mesh, s);
  pulse.beat(mesh.triangleCount());
  findCharts(s);
  pulse.beat(mesh.triangleCount());
  findLoops(s);
  pulse.beat(mesh.triangleCount());
  for (std::uint32_t f = 0; f < mesh.triangleCount(); ++f) {
    CutSurface::Chart& chart = s.charts[s.chartOfTriangle[f]];
    ++chart.triangles;
    chart.area += mesh.area[f];
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h)
      chart.edges += s.twin[h] == kNone || s.twin[h] > h;
  }
  for (std::uint32_t v = 0; v < s.vertexCount(); ++v) ++s.charts[s.chartOfVertex(v)].vertices;
  return s;
}

}  // namespace abflat
