#include "seam/symmetric_seams.h"

#include "hole/fill_holes.h"
#include "mesh/corner_table.h"

namespace abflat {
namespace {

/// Of most corners; what lies across goes anywhere.
bool isOnFirstSide(const SeamMesh& mesh, const Mirror& mirror, std::uint32_t triangle) {
  int sum = 0;
  for (std::uint32_t c = 3 * triangle; c < 3 * triangle + 3; ++c)
    sum += mirror.side[mesh.vertexOfCorner[c]];
  return sum > 0;
}

bool isBetween(const SeamMesh& mesh, const Mirror& mirror, std::uint32_t h) {
  return mesh.twin[h] != kNone &&
         isOnFirstSide(mesh, mirror, h / 3) != isOnFirstSide(mesh, mirror, mesh.twin[h] / 3);
}

}  // namespace

double mirroredShare(const SeamMesh& mesh, const Mirror& mirror, const Seams& seams) {
  double all = 0, mirrored = 0;
  for (std::size_t h = 0; h < seams.size(); ++h) {
    if (!seams[h]) continue;
    all += mesh.length[h];
    const std::uint32_t image = mirror.halfEdge[h];
    if (image != kNone && seams[image]) mirrored += mesh.length[h];
  }
  return all > 0 ? mirrored / all : 1;
}

std::optional<SeamPart> halfOf(const SeamMesh& mesh, const Mirror& mirror, FillHoles mode) {
  Seams between(mesh.twin.size(), 0);
  for (std::uint32_t h = 0; h < between.size(); ++h) {
    between[h] = isBetween(mesh, mirror, h);
    if (between[h] && !(mesh.cost[h] < kBarredCost)) return {};
  }
  CutSurface s = cutAlong(mesh, between);
  if (openTouchedHoles(mesh, s, mode, between)) s = cutAlong(mesh, between);
  std::vector<std::uint8_t> isWanted;
  for (const CutSurface::Chart& chart : s.charts)
    isWanted.push_back(isOnFirstSide(mesh, mirror, chart.firstTriangle) &&
                       !mesh.isFilling(chart.firstTriangle));
  return extractCharts(mesh, s, isWanted);
}

Seams unfold(const SeamMesh& mesh, const Mirror& mirror, const SeamPart& half, const Seams& seams) {
  Seams out(mesh.twin.size(), 0);
  const auto mark = [&](std::uint32_t h) {
    if (h == kNone || mesh.twin[h] == kNone || !(mesh.cost[h] < kBarredCost)) return;
    out[h] = out[mesh.twin[h]] = 1;
  };
  for (std::uint32_t h = 0; h < out.size(); ++h)
    if (isBetween(mesh, mirror, h)) mark(h);
  for (std::size_t i = 0; i < seams.size(); ++i) {
    if (!seams[i]) continue;
    mark(half.halfEdge[i]);
    mark(mirror.halfEdge[half.halfEdge[i]]);
  }
  return out;
}

}  // namespace abflat
