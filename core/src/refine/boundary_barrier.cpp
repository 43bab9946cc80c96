#include "refine/boundary_barrier.h"

#include <algorithm>
#include <cmath>

#include "check/validity.h"
#include "mesh/triangle_geometry.h"
#include "refine/near_pairs.h"

namespace abflat {
namespace {

constexpr double kShareOfEdge = 0.25;
/// Of the energy of as much surface as lies within reach.
constexpr double kStrength = 1;

}  // namespace

/// A vertex and the nearest point of an edge.
struct BoundaryBarrier::Contact : BoundaryContact {
  double distance, reach, weight;
};

BoundaryBarrier::BoundaryBarrier(const DiskChart& chart)
    : chart_(chart), area_(surfaceArea(chart)), reach_(kContactReach * std::sqrt(area_)) {
  for (const std::uint32_t h : chart.boundary)
    length_.push_back(norm(
        edgeVector(chart.positions, chart.vertexOfCorner[h], chart.vertexOfCorner[nextCorner(h)])));
}

std::vector<BoundaryBarrier::Contact> BoundaryBarrier::contacts(
    const std::vector<double>& uv) const {
  const std::vector<double> points = boundaryUv(chart_, uv);
  const std::size_t n = points.size() / 2;
  std::vector<Contact> out;
  for (const auto& [p, e] : findNearPairs(points, reach_)) {
    const std::size_t before = (p + n - 1) % n, end = (e + 1) % n;
    const double least = std::min({length_[before], length_[p], length_[e]});
    const double reach = std::min(reach_, kShareOfEdge * least);
    const double *x = &points[2 * p], *a = &points[2 * e], *b = &points[2 * end];
    const double ux = b[0] - a[0], uy = b[1] - a[1];
    const double square = ux * ux + uy * uy;
    const double along = ((x[0] - a[0]) * ux + (x[1] - a[1]) * uy) / square;
    const double share = square > 0 ? std::clamp(along, 0.0, 1.0) : 0;
    const double nx = x[0] - a[0] - share * ux, ny = x[1] - a[1] - share * uy;
    const double distance = norm(nx, ny);
    if (!(distance < reach)) continue;
    Contact c;
    const std::size_t places[3] = {p, e, end};
    for (std::size_t k = 0; k < 3; ++k)
      c.vertex[k] = chart_.vertexOfCorner[chart_.boundary[places[k]]];
    c.share[0] = 1;
    c.share[1] = share - 1;
    c.share[2] = -share;
    c.normal[0] = nx / distance;
    c.normal[1] = ny / distance;
    c.distance = distance;
    c.reach = reach;
    c.weight = kStrength * reach * (length_[before] + length_[p]) / 2 / area_;
    out.push_back(c);
  }
  return out;
}

double BoundaryBarrier::energy(const std::vector<double>& uv) const {
  double sum = 0;
  for (const Contact& c : contacts(uv)) {
    const double x = c.reach / c.distance - 1;
    sum += c.weight * x * x;
  }
  return sum;
}

void BoundaryBarrier::addDerivatives(const std::vector<double>& uv, Eigen::VectorXd& gradient,
                                     SparseEntries& hessian) const {
  for (const Contact& c : contacts(uv)) {
    const double ratio = c.reach / c.distance, inverse = 1 / c.distance;
    const double slope = -2 * c.weight * (ratio - 1) * ratio * inverse;
    const double curvature = 2 * c.weight * ratio * (3 * ratio - 2) * inverse * inverse;
    c.BoundaryContact::addDerivatives(slope, curvature, gradient, hessian);
  }
}

}  // namespace abflat
