#include "seam/components_with_seams.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace abflat {
namespace {

/// The least part of a mesh that is worth being left out.
constexpr std::size_t kLeastWithout = 16;

/// Per triangle, whether its component has a seam.
IdVector<SurfaceTriangle, std::uint8_t> reachedFromSeams(const SeamMesh& mesh, const Seams& seams) {
  IdVector<SurfaceTriangle, std::uint8_t> out(mesh.triangleCount(), 0);
  std::vector<SurfaceTriangle> open;
  const auto reach = [&](SurfaceTriangle f) {
    if (!std::exchange(out[f], 1)) open.push_back(f);
  };
  for (const SurfaceCorner h : seams.ids())
    if (seams[h]) reach(triangleOf(h));
  while (!open.empty()) {
    const SurfaceTriangle f = open.back();
    open.pop_back();
    for (const SurfaceCorner h : cornersOf(f))
      if (mesh.twin[h].exists()) reach(triangleOf(mesh.twin[h]));
  }
  return out;
}

}  // namespace

std::unique_ptr<const SeamPart> componentsWithSeams(const SeamMesh& mesh, const Seams& seams,
                                                    const Listener& listener) {
  const IdVector<SurfaceTriangle, std::uint8_t> isReached = reachedFromSeams(mesh, seams);
  const auto without = static_cast<std::size_t>(std::count(isReached.begin(), isReached.end(), 0));
  if (without * kLeastWithout < mesh.triangleCount()) return nullptr;
  const CutSurface components = cutAlong(mesh, Seams(mesh.twin.size(), 0), listener);
  IdVector<CutChartId, std::uint8_t> isWanted;
  for (const CutSurface::Chart& c : components.charts)
    isWanted.push_back(isReached[c.firstTriangle]);
  return std::make_unique<const SeamPart>(extractCharts(mesh, components, isWanted, listener));
}

}  // namespace abflat
