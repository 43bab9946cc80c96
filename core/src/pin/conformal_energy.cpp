#include "pin/conformal_energy.h"

#include <array>
#include <tuple>

#include "mesh/triangle_geometry.h"
#include "solve/sparse_assembly.h"

namespace abflat {
Eigen::SparseMatrix<double> conformalEnergy(const FlatRegion& region, std::size_t vertices,
                                            const std::vector<double>& angles) {
  const auto n = static_cast<int>(vertices);
  const auto endsOf = [&](ChartCorner h) {
    return std::array<int, 2>{static_cast<int>(region.vertexOfCorner[h]),
                              static_cast<int>(region.vertexOfCorner[nextCorner(h)])};
  };
  SparseEntries entries;
  entries.reserve(8 * angles.size() + 4 * region.boundary.size());
  for (const ChartCorner h : region.vertexOfCorner.ids()) {
    const auto [a, b] = endsOf(h);
    const double w = cotangent(angles[prevCorner(h)]) / 2;
    for (const int offset : {0, n}) {
      entries.emplace_back(a + offset, a + offset, w);
      entries.emplace_back(b + offset, b + offset, w);
      entries.emplace_back(a + offset, b + offset, -w);
      entries.emplace_back(b + offset, a + offset, -w);
    }
  }
  // Twice the area, sum of u_a v_b - u_b v_a over the boundary, as a symmetric matrix.
  for (const ChartCorner h : region.boundary) {
    const auto [a, b] = endsOf(h);
    for (const auto& [row, column, value] :
         {std::tuple{a, b + n, -0.5}, std::tuple{b, a + n, 0.5}}) {
      entries.emplace_back(row, column, value);
      entries.emplace_back(column, row, value);
    }
  }
  return assembled(2 * Eigen::Index{n}, entries);
}

}  // namespace abflat
