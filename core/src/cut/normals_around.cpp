#include "cut/normals_around.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cut/mesh_parts.h"
#include "mesh/vec3_sum.h"

namespace abflat {
namespace {

/// The middle of the coordinates along an axis; none is below 0.
double middleAlong(const SeamMesh& mesh, std::size_t axis) {
  double high = 0;
  for (std::size_t i = axis; i < mesh.positions.size(); i += 3)
    high = std::max(high, mesh.positions[i]);
  return high / 2;
}

}  // namespace

NormalsAround::NormalsAround(const SeamMesh& mesh) : mesh_(mesh) {
  constexpr double kReach = 0.1, kMostCells = 60;
  width_ = std::max(kReach * std::sqrt(mesh.totalArea()), 1 / kMostCells);
  // Coordinates are within the unit cube, and a point touches the cells on both sides of it.
  cells_ = static_cast<std::size_t>(std::ceil(1 / width_)) + 3;
  sum_.resize(cells_ * cells_ * cells_);
  // About the middle, so that mirror images count alike.
  for (std::size_t d = 0; d < 3; ++d)
    low_[d] = middleAlong(mesh, d) - width_ * static_cast<double>(cells_) / 2;
  const IdVector<SurfaceTriangle, Vec3> normal = triangleNormals(mesh);
  for (const SurfaceCorner h : mesh.corners()) {
    const SurfaceTriangle f = triangleOf(h);
    visitCells(middleOf(h), [&](std::size_t cell, double share) {
      sum_[cell] = sum(sum_[cell], normal[f], share * mesh.area[f]);
    });
  }
}

Vec3 NormalsAround::at(SurfaceCorner edge) const {
  Vec3 total{};
  visitCells(middleOf(edge),
             [&](std::size_t cell, double share) { total = sum(total, sum_[cell], share); });
  return unit(total);
}

/// Visits the eight cells nearest to a point, with the share of each.
template <class Visit>
void NormalsAround::visitCells(const Vec3& point, const Visit& visit) const {
  std::array<std::size_t, 3> first;
  std::array<std::array<double, 2>, 3> share;
  for (std::size_t d = 0; d < 3; ++d) {
    const double at = (point[d] - low_[d]) / width_ - 0.5;
    const int whole = static_cast<int>(at);
    const double toNext = at - whole;
    first[d] = static_cast<std::size_t>(whole);
    share[d] = {1 - toNext, toNext};
  }
  const std::size_t start = (first[0] * cells_ + first[1]) * cells_ + first[2];
  for (std::size_t z = 0; z < 2; ++z)
    for (std::size_t y = 0; y < 2; ++y)
      for (std::size_t x = 0; x < 2; ++x)
        visit(start + (x * cells_ + y) * cells_ + z, share[0][x] * share[1][y] * share[2][z]);
}

Vec3 NormalsAround::middleOf(SurfaceCorner edge) const {
  const double* const a = &mesh_.positions[3 * std::size_t{mesh_.tail(edge)}];
  const double* const b = &mesh_.positions[3 * std::size_t{mesh_.head(edge)}];
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

}  // namespace abflat
