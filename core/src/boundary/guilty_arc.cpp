#include "boundary/guilty_arc.h"

#include "base/constants.h"

namespace abflat {

std::vector<double> boundaryAngles(const DiskChart& chart, const AngleSolution& s) {
  std::vector<double> sum(chart.vertexCount(), 0), out;
  for (std::size_t c = 0; c < s.angles.size(); ++c) sum[chart.vertexOfCorner[c]] += s.angles[c];
  for (const std::uint32_t h : chart.boundary) out.push_back(sum[chart.vertexOfCorner[h]]);
  return out;
}

std::vector<double> turnedAlong(const std::vector<double>& boundaryAngles) {
  std::vector<double> turned(boundaryAngles.size() + 1, 0);
  for (std::size_t k = 0; k < boundaryAngles.size(); ++k)
    turned[k + 1] = turned[k] + kPi - boundaryAngles[k];
  return turned;
}

Arc guiltyArc(std::size_t i, std::size_t j, const std::vector<double>& turned) {
  const std::size_t n = turned.size() - 1;
  const double inner = turned[j + 1] - turned[i + 1];
  return inner < turned[n] - inner ? Arc{i + 1, j - i} : Arc{j + 1, n - (j - i)};
}

}  // namespace abflat
