#include "abflat/inspect.h"

#include <set>

#include "abflat/mesh.h"
#include "base/guarded.h"
#include "mesh/surface.h"

namespace abflat {

MeshSummary inspect(const PolygonMesh& mesh) {
  const Result<MeshSummary> summary =
      guarded([&]() -> Result<MeshSummary> { return inspect(mesh, Listener()); });
  if (summary.ok()) return summary.value();
  MeshSummary unknown;
  unknown.disk = summary.status();
  return unknown;
}

MeshSummary inspect(const PolygonMesh& mesh, const Listener& listener) {
  MeshSummary summary;
  summary.disk = validateArrays(mesh);
  if (!summary.disk.ok()) return summary;
  summary = buildSurface(mesh, listener).summary;
  summary.texcoords = mesh.texcoords.size() / 2;
  summary.normals = mesh.normals.size() / 3;
  const std::set<std::uint32_t> groups(mesh.faceSmoothing.begin(), mesh.faceSmoothing.end());
  summary.smoothingGroups = groups.size();
  const std::set<std::uint32_t> materials(mesh.faceMaterials.begin(), mesh.faceMaterials.end());
  summary.materials = materials.size();
  return summary;
}

}  // namespace abflat
