#include "refine/straight_parts.h"

#include "base/point2.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

StraightParts::StraightParts(const DiskChart& chart, const StraightPlaces& straight)
    : chart_(chart) {
  for (const BoundaryIndex i : straight.ids()) {
    if (straight[i] || !straight[chart_.after(i)]) continue;
    Run run{i, chart_.after(chart_.after(i))};
    while (straight[run.to]) run.to = chart_.after(run.to);
    runs_.push_back(run);
  }
}

double StraightParts::shareOf(const Run& run, ChartVertex vertex,
                              const std::vector<double>& uv) const {
  const auto [a, b, x] =
      pointsOf(uv, {chart_.boundaryVertex(run.from), chart_.boundaryVertex(run.to), vertex});
  const double ux = b[0] - a[0], uy = b[1] - a[1], square = ux * ux + uy * uy;
  return ((x[0] - a[0]) * ux + (x[1] - a[1]) * uy) / square;
}

void StraightParts::straighten(std::vector<double>& uv) const {
  for (const Run& run : runs_) {
    const Point2 a = pointAt(uv, chart_.boundaryVertex(run.from));
    const Point2 b = pointAt(uv, chart_.boundaryVertex(run.to));
    within(run, [&](ChartVertex v) {
      const double share = shareOf(run, v, uv);
      setPoint(uv, v, {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])});
    });
  }
}

}  // namespace abflat
