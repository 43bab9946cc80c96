#include "boundary/requested_bounds.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "base/stable_order.h"

namespace abflat {
namespace {

/// Condition (5), as t. At exactly 2, two boundary edges would coincide, and rounding would decide
/// whether they cross.
constexpr double kAdjacentBound = 2 - 1e-6;

/// From here on, a bound allows every angle.
constexpr double kFree = 2;

bool isBound(double t) { return t > 0 && std::isfinite(t); }

/// The n boundary angles sum to (n - 2) pi, since interior vertices take 2 pi each.
Status checkSum(const BoundaryBounds& t, double common) {
  const auto n = static_cast<double>(t.size());
  double sum = 0;
  for (const double x : t) sum += x;
  if (sum >= (n - 2) * (1 - 1e-14)) return {};  // up to the rounding of the sum
  const bool uniform = std::all_of(t.begin(), t.end(), [&](double x) { return x == common; });
  const std::string vertices = std::to_string(t.size()) + " boundary vertices";
  if (uniform)
    return {StatusCode::InfeasibleBound, "t = " + withDigits(common, 6) + " is too small: with " +
                                             vertices + ", t must be at least " +
                                             withDigits(1 - 2 / n, 17)};
  return {StatusCode::InfeasibleBound, "the bounds cannot be met: they sum to " +
                                           withDigits(sum, 6) + " pi, but the interior angles of " +
                                           vertices + " sum to " + withDigits(n - 2, 6) +
                                           " pi. Raise t, or some of the bounds"};
}

}  // namespace

Result<BoundaryBounds> requestedBounds(const DiskChart& chart, const FlattenOptions& options,
                                       const StraightPlaces& straight) {
  if (options.t != kAutoT && !isBound(options.t))
    return Status{StatusCode::InvalidOption, "t must be a number above 0, or auto"};
  double common = options.t == kAutoT ? 2 : options.t;
  if (options.adjacent) common = std::min(common, kAdjacentBound);
  BoundaryBounds t(chart.boundary.size(), common);
  if (!options.bounds.empty()) {
    // A vertex that the boundary touches twice has two places.
    std::vector<std::pair<std::uint32_t, BoundaryIndex>> places;
    for (const BoundaryIndex i : t.ids())
      places.emplace_back(chart.inputVertex[chart.boundaryVertex(i)], i);
    sortStably(places, std::less<>());
    for (const VertexBound& b : options.bounds) {
      auto place =
          std::lower_bound(places.begin(), places.end(), std::pair(b.vertex, BoundaryIndex(0)));
      if (place == places.end() || place->first != b.vertex)
        return Status{StatusCode::InvalidOption, "vertex " + std::to_string(b.vertex) +
                                                     " has a bound but is not on the boundary"};
      if (!isBound(b.t))
        return Status{StatusCode::InvalidOption, "the bound of vertex " + std::to_string(b.vertex) +
                                                     " must be a number above 0"};
      for (; place != places.end() && place->first == b.vertex; ++place) t[place->second] = b.t;
    }
  }
  BoundaryBounds met = t;
  for (const BoundaryIndex i : straight.ids())
    if (straight[i] != 0) met[i] = 1;
  if (Status s = checkSum(met, common); !s.ok()) return s;
  return t;
}

std::vector<VertexBound> vertexBounds(const DiskChart& chart, const BoundaryBounds& t) {
  std::vector<VertexBound> out;
  for (const BoundaryIndex i : t.ids())
    if (t[i] < kFree) out.push_back({chart.boundaryVertex(i), t[i]});
  return out;
}

BoundaryBounds boundsOf(const DiskChart& chart, const std::vector<VertexBound>& bounds) {
  IdVector<ChartVertex, double> ofVertex(chart.vertexCount(), kFree);
  for (const VertexBound& b : bounds) ofVertex[ChartVertex(b.vertex)] = b.t;
  BoundaryBounds out;
  for (const ChartCorner h : chart.boundary) out.push_back(ofVertex[chart.vertexOfCorner[h]]);
  return out;
}

}  // namespace abflat
