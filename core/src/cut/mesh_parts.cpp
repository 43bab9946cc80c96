#include "cut/mesh_parts.h"

#include "base/disjoint_sets.h"

namespace abflat {

IdVector<SurfaceTriangle, Vec3> triangleNormals(const SeamMesh& mesh) {
  IdVector<SurfaceTriangle, Vec3> out;
  out.reserve(mesh.triangleCount());
  for (const SurfaceTriangle f : mesh.triangles())
    out.push_back(unitNormal(mesh.positions, verticesOf(mesh.vertexOfCorner, f)));
  return out;
}

IdVector<SurfaceTriangle, SurfaceTriangle> componentsOf(const SeamMesh& mesh) {
  DisjointSets parts(mesh.triangleCount());
  for (const SurfaceCorner h : mesh.corners())
    if (const SurfaceCorner o = mesh.twin[h]; o > h && o.exists())
      parts.join(triangleOf(h), triangleOf(o));
  IdVector<SurfaceTriangle, SurfaceTriangle> out;
  out.reserve(mesh.triangleCount());
  for (const SurfaceTriangle f : mesh.triangles()) out.push_back(SurfaceTriangle(parts.leastOf(f)));
  return out;
}

}  // namespace abflat
