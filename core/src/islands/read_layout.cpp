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

IslandMaterials materialsOf(const PolygonMesh& mesh, const MappedTriangles& triangles) {
  IslandMaterials out(triangles.inUv.islands());
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    std::vector<std::uint32_t>& own = out[i];
    for (std::uint32_t t = triangles.inUv.begin[i]; t < triangles.inUv.begin[i + 1]; ++t) {
      const std::uint32_t material = mesh.faceMaterials[triangles.face[t]];
      if (own.empty() || own.back() != material) own.push_back(material);
    }
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
  }
  return out;
}

}  // namespace

std::uint32_t MeshLayout::stackOf(std::uint32_t face) const {
  const std::uint32_t island = islandOfFace[face];
  return island == kNoIsland ? kNoStack : stackOfIsland[island];
}

MeshLayout readLayout(const PolygonMesh& mesh, Islands islands, bool byMaterial,
                      const Listener& listener) {
  MeshLayout out;
  listTriangles(mesh, islands, out);
  out.islandOfFace = std::move(islands.ofFace);
  if (!listener.tell(0.2)) return out;
  const bool hasMaterials = byMaterial && !mesh.faceMaterials.empty();
  const IslandStacks found =
      stackIslands(out.triangles.inUv,
                   hasMaterials ? materialsOf(mesh, out.triangles) : IslandMaterials(), listener);
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
