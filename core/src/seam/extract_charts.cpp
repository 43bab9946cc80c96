#include "seam/extract_charts.h"

namespace abflat {

SeamPart extractCharts(const SeamMesh& mesh, const CutSurface& s,
                       const std::vector<std::uint8_t>& isWanted, const Pulse& pulse) {
  SeamPart part;
  SeamMesh& m = part.mesh;
  std::vector<std::uint32_t> vertex(s.vertexCount(), kNone), place(s.twin.size(), kNone);
  for (std::uint32_t f = 0; f < mesh.triangleCount(); ++f) {
    if (!isWanted[s.chartOfTriangle[f]]) continue;
    m.area.push_back(mesh.area[f]);
    if (!mesh.hole.empty()) m.hole.push_back(mesh.hole[f]);
    if (!mesh.excess.empty()) m.excess.push_back(mesh.excess[f]);
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
      place[h] = static_cast<std::uint32_t>(part.halfEdge.size());
      part.halfEdge.push_back(h);
    }
  }
  for (const std::uint32_t h : part.halfEdge) {
    pulse.beat();
    const std::uint32_t v = s.vertexOfCorner[h], i = s.meshVertex[v];
    if (vertex[v] == kNone) {
      vertex[v] = static_cast<std::uint32_t>(m.vertexArea.size());
      m.positions.insert(m.positions.end(), &mesh.positions[3 * i], &mesh.positions[3 * i] + 3);
      part.vertex.push_back(i);
      m.vertexArea.push_back(0);
      m.angleSum.push_back(0);
    }
    m.vertexOfCorner.push_back(vertex[v]);
    m.twin.push_back(s.twin[h] == kNone ? kNone : place[s.twin[h]]);
    m.angle.push_back(mesh.angle[h]);
    m.length.push_back(mesh.length[h]);
    m.cost.push_back(mesh.cost[h]);
    m.weight.push_back(mesh.weight[h]);
    m.vertexArea[vertex[v]] += mesh.area[h / 3] / 3;
    m.angleSum[vertex[v]] += mesh.angle[h];
  }
  return part;
}

}  // namespace abflat
