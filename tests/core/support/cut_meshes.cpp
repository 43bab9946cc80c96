#include "support/cut_meshes.h"

#include <map>
#include <numeric>

namespace abflat::test {
namespace {

std::uint32_t find(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

void join(std::vector<std::uint32_t>& parent, std::uint32_t a, std::uint32_t b) {
  parent[find(parent, a)] = find(parent, b);
}

}  // namespace

Cuttable::Cuttable(PolygonMesh polygons)
    : mesh(std::move(polygons)),
      surface(buildSurface(mesh)),
      seamMesh(makeSeamMesh(mesh.positions, surface.table, surface.fans)) {}

std::vector<PolygonMesh> chartsOf(const Cuttable& cuttable, const Seams& seams) {
  const CornerTable& table = cuttable.surface.table;
  const auto corners = static_cast<std::uint32_t>(table.vertex.size());
  std::vector<std::uint32_t> vertex(corners), triangle(corners / 3);
  std::iota(vertex.begin(), vertex.end(), 0u);
  std::iota(triangle.begin(), triangle.end(), 0u);
  for (const SurfaceCorner h : table.corners()) {
    const SurfaceCorner o = table.twin[h];
    if (!o.exists() || seams[h]) continue;
    join(triangle, h / 3, o / 3);
    join(vertex, h, nextCorner(o));
    join(vertex, nextCorner(h), o);
  }
  struct Parts {
    std::vector<double> positions;
    std::vector<std::uint32_t> indices;
    std::map<std::uint32_t, std::uint32_t> id;
  };
  std::map<std::uint32_t, Parts> parts;
  for (std::uint32_t c = 0; c < corners; ++c) {
    Parts& p = parts[find(triangle, c / 3)];
    const auto [at, isNew] = p.id.emplace(find(vertex, c), static_cast<std::uint32_t>(p.id.size()));
    if (isNew)
      for (std::size_t d = 0; d < 3; ++d)
        p.positions.push_back(cuttable.mesh.positions[3 * table.vertex[SurfaceCorner(c)] + d]);
    p.indices.push_back(at->second);
  }
  std::vector<PolygonMesh> charts;
  for (auto& [root, p] : parts)
    charts.push_back(makeTriangleMesh(std::move(p.positions), std::move(p.indices)));
  return charts;
}

}  // namespace abflat::test
