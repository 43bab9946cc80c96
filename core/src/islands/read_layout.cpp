#include "islands/read_layout.h"

#include <algorithm>
#include <utility>

#include "abflat/pack_layout.h"
#include "islands/stack_islands.h"
#include "mesh/input_mesh.h"
#include "mesh/triangulate.h"

namespace abflat {
namespace {

std::vector<std::uint32_t> stacksOfIslands(const std::vector<IslandStack>& stacks,
                                           std::size_t islands) {
  std::vector<std::uint32_t> out(islands);
  for (std::uint32_t s = 0; s < stacks.size(); ++s)
    for (const std::uint32_t i : stacks[s].islands) out[i] = s;
  return out;
}

void listTriangles(const PolygonMesh& mesh, const Islands& islands, MeshLayout& out) {
  const Triangulation all = triangulate(mesh);
  out.triangleCorners.assign(all.corner.begin(), all.corner.end());
  out.triangles = mappedTriangles(mesh, islands, all);
}

}  // namespace

std::uint32_t MeshLayout::stackOf(std::uint32_t face) const {
  const std::uint32_t island = islandOfFace[face];
  return island == kNoIsland ? kNoStack : stackOfIsland[island];
}

MeshLayout readLayout(const PolygonMesh& mesh, Islands islands, const Listener& listener) {
  MeshLayout out;
  listTriangles(mesh, islands, out);
  out.islandOfFace = std::move(islands.ofFace);
  if (!listener.tell(0.2)) return out;
  const IslandStacks found = stackIslands(out.triangles.inUv, listener);
  if (listener.isStopped()) return out;
  out.separated = static_cast<std::size_t>(
      std::count(found.overlapsOthers.begin(), found.overlapsOthers.end(), 1));
  out.exponent = exponentOf(mesh);
  out.stacks =
      listStacks(out.triangles.inUv, found.first, surfaceAreas(mesh, out.triangles, out.exponent));
  out.stackOfIsland = stacksOfIslands(out.stacks, islands.count);
  return out;
}

}  // namespace abflat
