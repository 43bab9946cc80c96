#include "abflat/inspect.h"

#include "abflat/io.h"
#include "mesh/surface.h"

namespace abflat {

MeshSummary inspect(const PolygonMesh& mesh) {
  MeshSummary summary;
  summary.disk = validateArrays(mesh);
  return summary.disk.ok() ? buildSurface(mesh).summary : summary;
}

}  // namespace abflat
