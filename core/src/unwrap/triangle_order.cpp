#include "unwrap/triangle_order.h"

namespace abflat {

TriangleOrder triangleOrder(const SurfaceMap& map) {
  const InputMesh& input = map.input();
  const IdRange<SurfaceTriangle> triangles = map.surface().table.triangles();
  IdVector<InputFace, std::uint32_t> count(input.faceCount(), 0);
  for (const SurfaceTriangle f : triangles) ++count[map.face(f)];
  TriangleOrder out;
  out.firstOfFace.reserve(input.faceCount() + 1);
  out.isFolded.reserve(input.faceCount());
  OutputTriangle next(0);
  for (const InputFace f : count.ids()) {
    const std::size_t corners = input.firstCorner(f + 1) - input.firstCorner(f);
    out.isFolded.push_back(count[f] == 0);
    out.firstOfFace.push_back(next);
    next = OutputTriangle(next + (count[f] == 0 ? corners - 2 : count[f]));
  }
  out.firstOfFace.push_back(next);
  IdVector<InputFace, OutputTriangle> fill = out.firstOfFace;
  out.ofTriangle.reserve(triangles.size());
  for (const SurfaceTriangle f : triangles) {
    OutputTriangle& at = fill[map.face(f)];
    out.ofTriangle.push_back(at);
    ++at;
  }
  return out;
}

}  // namespace abflat
