#include "seam/principal_axes.h"

#include <cmath>

#include "base/few_bits.h"
#include "base/stable_order.h"

namespace abflat {
namespace {

using Matrix = std::array<Vec3, 3>;

/// The eigenvectors of a symmetric matrix, by Jacobi's rotations; that of the largest eigenvalue
/// first.
Matrix eigenvectors(Matrix a) {
  constexpr int kSweeps = 12;
  constexpr double kRounding = 1e-9;
  const double least = kRounding * (a[0][0] + a[1][1] + a[2][2]);
  Matrix v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (std::size_t p = 0; p < 3; ++p)
      for (std::size_t q = p + 1; q < 3; ++q) {
        if (!(std::abs(a[p][q]) > least)) continue;
        const double ratio = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double root = std::abs(ratio) + std::sqrt(ratio * ratio + 1);
        const double tangent = (ratio < 0 ? -1 : 1) / root;
        const double c = 1 / std::sqrt(tangent * tangent + 1), s = tangent * c;
        for (std::size_t i = 0; i < 3; ++i) {
          const double x = a[i][p], y = a[i][q];
          a[i][p] = c * x - s * y;
          a[i][q] = s * x + c * y;
        }
        for (Matrix* m : {&a, &v})
          for (std::size_t i = 0; i < 3; ++i) {
            const double x = (*m)[p][i], y = (*m)[q][i];
            (*m)[p][i] = c * x - s * y;
            (*m)[q][i] = s * x + c * y;
          }
      }
  const std::vector<std::uint32_t> order = stableOrder(
      3, [&](std::uint32_t i, std::uint32_t j) { return inFewBits(a[i][i]) > inFewBits(a[j][j]); });
  return {v[order[0]], v[order[1]], v[order[2]]};
}

Vec3 minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

}  // namespace

Vec3 centreOf(const SeamMesh& mesh, SurfaceTriangle triangle) {
  Vec3 out{};
  for (const SurfaceCorner c : cornersOf(triangle)) {
    const double* p = &mesh.positions[3 * std::size_t{mesh.vertexOfCorner[c]}];
    for (std::size_t i = 0; i < 3; ++i) out[i] += p[i] / 3;
  }
  return out;
}

PrincipalAxes principalAxes(const SeamMesh& mesh) {
  const double all = mesh.totalArea();
  PrincipalAxes out;
  if (!(all > 0)) return out;
  const auto addUp = [&](const auto& add) {
    for (const SurfaceTriangle f : mesh.triangles())
      add(mesh.area[f] / all, minus(centreOf(mesh, f), out.middle));
  };
  Vec3 middle{};
  addUp([&](double share, const Vec3& p) {
    for (std::size_t i = 0; i < 3; ++i) middle[i] += share * p[i];
  });
  out.middle = middle;
  Matrix spread{};
  addUp([&](double share, const Vec3& p) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) spread[i][j] += share * p[i] * p[j];
  });
  out.axes = eigenvectors(spread);
  Vec3 skew{};
  addUp([&](double share, const Vec3& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = dot(out.axes[i], p);
      skew[i] += share * x * x * x;
    }
  });
  constexpr double kLeastSkew = 1e-9;
  for (std::size_t i = 0; i < 3; ++i)
    if (skew[i] < -kLeastSkew)
      for (double& x : out.axes[i]) x = -x;
  return out;
}

}  // namespace abflat
