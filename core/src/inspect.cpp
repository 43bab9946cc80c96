#include "abflat/inspect.h"

#include <algorithm>

#include "abflat/io.h"
#include "mesh/surface.h"

namespace abflat {

MeshSummary inspect(const PolygonMesh& mesh) {
  MeshSummary summary;
  summary.disk = validateArrays(mesh);
  if (!summary.disk.ok()) return summary;
  summary = buildSurface(mesh).summary;
  summary.texcoords = mesh.texcoords.size() / 2;
  for (const std::size_t material : mesh.faceMaterials)
    summary.materials = std::max(summary.materials, material + 1);
  return summary;
}

}  // namespace abflat
