#include "abflat/inspect.h"

#include "mesh/surface.h"

namespace abflat {

MeshSummary inspect(const PolygonMesh& mesh) { return buildSurface(mesh).summary; }

}  // namespace abflat
