#include "abflat/gltf.h"
#include "mesh/surface.h"
#include "mesh/weld.h"

namespace abflat {

std::size_t joinVertices(PolygonMesh& mesh) {
  if (inspect(mesh, Listener()).disk.ok()) return 0;
  mesh.vertexObjects = {};
  const Welding welding = weldSurface(mesh);
  for (std::uint32_t& v : mesh.faceVertices) v = welding.ofVertex[v];
  return welding.merged;
}

}  // namespace abflat
