#include "boundary/missed_angles.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "check/validity.h"

namespace abflat {
namespace {

void add(double missedBy, double rounding, MissedAngles& out) {
  out.count += missedBy > rounding;
  out.most = std::max(out.most, missedBy);
}

}  // namespace

MissedAngles exceededBounds(const DiskChart& chart, const std::vector<double>& uv,
                            const BoundaryBounds& t, const StraightPlaces& straight,
                            double rounding) {
  MissedAngles out;
  for (const BoundaryIndex i : t.ids())
    if (t[i] < 2 && (straight.empty() || straight[i] == 0))
      add(boundaryAngle(chart, uv, chart.boundary[i]) - t[i] * kPi, rounding, out);
  return out;
}

MissedAngles bentPlaces(const DiskChart& chart, const std::vector<double>& uv,
                        const StraightPlaces& straight, double rounding) {
  MissedAngles out;
  for (const BoundaryIndex i : straight.ids())
    if (straight[i] != 0)
      add(std::abs(boundaryAngle(chart, uv, chart.boundary[i]) - kPi), rounding, out);
  return out;
}

}  // namespace abflat
