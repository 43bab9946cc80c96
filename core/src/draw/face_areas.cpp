#include "draw/face_areas.h"

#include <cmath>

#include "draw/atlas_polygons.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Twice the area of a triangle of the fan from `o`.
double doubleArea(const UnwrapResult& result, std::uint32_t o, std::uint32_t a, std::uint32_t b) {
  const auto uv = [&](std::uint32_t corner) {
    return &result.uv[2 * static_cast<std::size_t>(result.cornerUv[corner])];
  };
  const double *p = uv(o), *q = uv(a), *r = uv(b);
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

}  // namespace

FaceAreas faceAreas(const PolygonMesh& mesh, const UnwrapResult& result) {
  FaceAreas out;
  out.in3d.resize(mesh.faceCount());
  out.inUv.resize(mesh.faceCount());
  const AtlasPolygons polygons = atlasPolygons(mesh, result);
  for (std::uint32_t i = 0; i < polygons.count(); ++i) {
    Vec3 vector{};
    double inUv = 0;
    const std::uint32_t o = polygons.corners[polygons.offsets[i]];
    for (std::uint32_t k = polygons.offsets[i] + 1; k + 1 < polygons.offsets[i + 1]; ++k) {
      const std::uint32_t a = polygons.corners[k], b = polygons.corners[k + 1];
      const std::uint32_t* v = mesh.faceVertices.data();
      const Vec3 part =
          cross(edgeVector(mesh.positions, v[o], v[a]), edgeVector(mesh.positions, v[o], v[b]));
      for (std::size_t d = 0; d < 3; ++d) vector[d] += part[d] / 2;
      inUv += doubleArea(result, o, a, b) / 2;
    }
    out.in3d[polygons.face[i]] += norm(vector);
    out.inUv[polygons.face[i]] += std::abs(inUv);
    out.sum += norm(vector);
    out.uvSum += std::abs(inUv);
  }
  return out;
}

}  // namespace abflat
