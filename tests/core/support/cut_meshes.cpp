#include "support/cut_meshes.h"

#include <map>

namespace abflat::test {
namespace {

/// Disjoint sets, each identified by one of its members.
template <class I>
class Sets {
 public:
  explicit Sets(IdRange<I> all) : parent_(all.size()) {
    for (const I i : all) parent_[i] = i;
  }
  I find(I i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(I a, I b) { parent_[find(a)] = find(b); }

 private:
  IdVector<I, I> parent_;
};

}  // namespace

Cuttable::Cuttable(PolygonMesh polygons, SeamCosts costs)
    : mesh(std::move(polygons)),
      surface(buildSurface(mesh)),
      seamMesh(makeSeamMesh(mesh.positions, surface.table, surface.fans, {}, {}, {}, costs)) {}

std::vector<PolygonMesh> chartsOf(const Cuttable& cuttable, const Seams& seams) {
  const CornerTable& table = cuttable.surface.table;
  Sets<SurfaceCorner> vertex(table.corners());
  Sets<SurfaceTriangle> triangle(table.triangles());
  for (const SurfaceCorner h : table.corners()) {
    const SurfaceCorner o = table.twin[h];
    if (!o.exists() || seams[h]) continue;
    triangle.join(triangleOf(h), triangleOf(o));
    vertex.join(h, nextCorner(o));
    vertex.join(nextCorner(h), o);
  }
  struct Parts {
    std::vector<double> positions;
    std::vector<std::uint32_t> indices;
    std::map<SurfaceCorner, std::uint32_t> id;
  };
  std::map<SurfaceTriangle, Parts> parts;
  for (const SurfaceCorner c : table.corners()) {
    Parts& p = parts[triangle.find(triangleOf(c))];
    const auto [at, isNew] = p.id.emplace(vertex.find(c), static_cast<std::uint32_t>(p.id.size()));
    if (isNew)
      for (std::size_t d = 0; d < 3; ++d)
        p.positions.push_back(cuttable.mesh.positions[3 * table.vertex[c] + d]);
    p.indices.push_back(at->second);
  }
  std::vector<PolygonMesh> charts;
  for (auto& [root, p] : parts)
    charts.push_back(makeTriangleMesh(std::move(p.positions), std::move(p.indices)));
  return charts;
}

}  // namespace abflat::test
