#include "boundary/blamed_arc.h"

#include "base/constants.h"
#include "check/validity.h"

namespace abflat {

IdVector<BoundaryIndex, double> boundaryAngles(const DiskChart& chart, const AngleSolution& s) {
  IdVector<ChartVertex, double> sum(chart.vertexCount(), 0);
  // Tutte's embedding has no angles.
  for (const ChartCorner c : IdRange<ChartCorner>(s.angles.size()))
    sum[chart.vertexOfCorner[c]] += s.angles[c];
  IdVector<BoundaryIndex, double> out;
  for (const ChartCorner h : chart.boundary) out.push_back(sum[chart.vertexOfCorner[h]]);
  return out;
}

IdVector<BoundaryIndex, double> boundaryAngles(const DiskChart& chart,
                                               const std::vector<double>& uv) {
  IdVector<BoundaryIndex, double> out;
  for (const ChartCorner h : chart.boundary) out.push_back(boundaryAngle(chart, uv, h));
  return out;
}

std::vector<double> turnedAlong(const IdVector<BoundaryIndex, double>& boundaryAngles) {
  std::vector<double> turned(boundaryAngles.size() + 1, 0);
  for (const BoundaryIndex k : boundaryAngles.ids())
    turned[k + 1] = turned[k] + kPi - boundaryAngles[k];
  return turned;
}

Arc blamedArc(std::size_t i, std::size_t j, const std::vector<double>& turned) {
  const std::size_t n = turned.size() - 1;
  const double inner = turned[j + 1] - turned[i + 1];
  return inner < turned[n] - inner ? Arc{i + 1, j - i} : Arc{j + 1, n - (j - i)};
}

}  // namespace abflat
