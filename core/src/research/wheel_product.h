#pragma once

#include <vector>

#include "angle/angle_problem.h"

namespace abflat {

/// The wheel constraint of an interior vertex as Sheffer and de Sturler wrote it, eq. (3):
/// next - prev = 0, products of the sines of the angles after and before the vertex.
struct WheelProduct {
  double next = 1, prev = 1;
  double value() const { return next - prev; }
};

/// Entries of boundary vertices are meaningless.
using WheelProducts = IdVector<ChartVertex, WheelProduct>;
WheelProducts wheelProducts(const AngleProblem& problem, const std::vector<double>& angles);

/// Corners round each vertex.
struct VertexCorners {
  std::vector<std::uint32_t> offset;  ///< per vertex: where its corners begin in the next array
  std::vector<ChartCorner> corner;
};
VertexCorners cornersOfVertices(const AngleProblem& problem);

/// Visits (row corner, column corner, value) of the second derivatives of vertex v's wheel: a full
/// block on the corners of its rim, in contrast to the diagonal one of the logarithmic form.
template <class Visit>
void forEachSecondDerivative(const VertexCorners& corners, const std::vector<double>& cot,
                             const WheelProduct& wheel, ChartVertex v, Visit&& visit) {
  for (const bool isNext : {true, false}) {
    const double p = isNext ? wheel.next : -wheel.prev;
    const auto rim = [&](std::uint32_t i) {
      const ChartCorner c = corners.corner[i];
      return isNext ? nextCorner(c) : prevCorner(c);
    };
    for (std::uint32_t i = corners.offset[v]; i < corners.offset[v + 1]; ++i)
      for (std::uint32_t j = corners.offset[v]; j < corners.offset[v + 1]; ++j)
        visit(rim(i), rim(j), i == j ? -p : p * cot[rim(i)] * cot[rim(j)]);
  }
}

}  // namespace abflat
