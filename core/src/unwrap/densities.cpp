#include "unwrap/densities.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/number_text.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr double kLeast = 1e-3, kMost = 1e3;

std::string text(double number) {
  char digits[kMostDoubleChars];
  return {digits, writeDouble(digits, number)};
}

double areaOf(const SurfaceMap& map, SurfaceTriangle f) {
  const auto& vertex = map.surface().table.vertex;
  const std::vector<double>& positions = map.welded().mesh.positions;
  const auto at = [&](std::size_t k) { return vertex[cornerOf(f, k)]; };
  return norm(cross(edgeVector(positions, at(0), at(1)), edgeVector(positions, at(0), at(2))));
}

}  // namespace

Status checkDensities(const std::vector<double>& ofFace, std::size_t faces) {
  if (ofFace.empty()) return {};
  const auto invalid = [](std::string text) {
    return Status{StatusCode::InvalidOption, std::move(text)};
  };
  if (ofFace.size() != faces)
    return invalid("there are " + std::to_string(ofFace.size()) + " face densities for " +
                   std::to_string(faces) + " faces. Give one per face, or none");
  for (std::size_t f = 0; f < faces; ++f)
    if (!(ofFace[f] >= kLeast && ofFace[f] <= kMost))
      return invalid("the density of face " + std::to_string(f) + " is " + text(ofFace[f]) +
                     "; it must be from 0.001 to 1000, where 1 is that of other faces");
  return {};
}

IdVector<ChartId, double> densitiesOf(const CutMesh& mesh, const std::vector<double>& ofFace) {
  IdVector<ChartId, double> out;
  if (std::all_of(ofFace.begin(), ofFace.end(), [](double d) { return d == 1; })) return out;
  for (const ChartId i : mesh.set.ids()) {
    double area = 0, texels = 0;
    for (const SurfaceTriangle f : mesh.set.topology(i).triangles) {
      const double density = ofFace[mesh.map.face(f)];
      area += areaOf(mesh.map, f);
      texels += areaOf(mesh.map, f) * density * density;
    }
    out.push_back(area > 0 ? std::sqrt(texels / area) : 1);
  }
  return out;
}

}  // namespace abflat
