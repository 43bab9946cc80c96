#include "unwrap/densities.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/invalid.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr double kLeastDensity = 1e-3, kMostDensity = 1e3;

}  // namespace

Status checkDensities(const std::vector<double>& ofFace, std::size_t faces) {
  if (ofFace.empty()) return {};
  if (ofFace.size() != faces)
    return invalid("there are " + std::to_string(ofFace.size()) + " face densities for " +
                   std::to_string(faces) + " faces. Give one per face, or none");
  for (std::size_t f = 0; f < faces; ++f)
    if (!(ofFace[f] >= kLeastDensity && ofFace[f] <= kMostDensity))
      return invalid("the density of face " + std::to_string(f) +
                     " must be from 0.001 to 1000, where 1 is that of other faces");
  return {};
}

IdVector<ChartId, double> densitiesOf(const CutMesh& mesh, const std::vector<double>& ofFace,
                                      const std::vector<double>& positions) {
  IdVector<ChartId, double> out;
  const std::vector<double>& drawn = mesh.map.welded().mesh.positions;
  const bool isSmoothed = !positions.empty();
  const bool areAlike = std::all_of(ofFace.begin(), ofFace.end(), [](double d) { return d == 1; });
  if (areAlike && !isSmoothed) return out;
  for (const ChartId i : mesh.set.ids()) {
    double area = 0, texels = 0;
    for (const SurfaceTriangle f : mesh.set.topology(i).triangles) {
      const double density = areAlike ? 1 : ofFace[mesh.map.face(f)];
      const TriangleVertices v = verticesOf(mesh.map.surface().table.vertex, f);
      const double part = areaOf(drawn, v);
      area += part;
      texels += (isSmoothed ? areaOf(positions, v) : part) * density * density;
    }
    out.push_back(area > 0 ? std::sqrt(texels / area) : 1);
  }
  return out;
}

}  // namespace abflat
