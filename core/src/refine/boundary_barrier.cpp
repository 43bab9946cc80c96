#include "refine/boundary_barrier.h"

#include <algorithm>
#include <cmath>

#include "check/validity.h"
#include "mesh/triangle_geometry.h"
#include "refine/near_pairs.h"

namespace abflat {
namespace {

constexpr double kShareOfEdge = 0.25;
/// Relative to the energy of as much surface as lies within reach.
constexpr double kBarrierStrength = 0.1;

}  // namespace

/// A vertex and the nearest point of an edge.
struct BoundaryBarrier::Contact : BoundaryContact {
  double distance, reach, weight;
};

BoundaryBarrier::BoundaryBarrier(const DiskChart& chart, double reach)
    : chart_(chart), area_(surfaceArea(chart)), reach_(reach) {
  for (const ChartCorner h : chart.boundary)
    length_.push_back(norm(
        edgeVector(chart.positions, chart.vertexOfCorner[h], chart.vertexOfCorner[nextCorner(h)])));
}

std::vector<BoundaryBarrier::Contact> BoundaryBarrier::contacts(
    const std::vector<double>& uv) const {
  const std::vector<double> points = boundaryUv(chart_, uv);
  std::vector<Contact> out;
  for (const NearPair& pair : findNearPairs(points, reach_)) {
    const BoundaryIndex p(pair.point), e(pair.edge);
    const BoundaryIndex before = chart_.before(p), end = chart_.after(e);
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
    Contact c{distanceContact(
                  {chart_.boundaryVertex(p), chart_.boundaryVertex(e), chart_.boundaryVertex(end)},
                  share, {nx / distance, ny / distance}),
              distance, reach,
              kBarrierStrength * reach * (length_[before] + length_[p]) / 2 / area_};
    out.push_back(c);
  }
  return out;
}

double BoundaryBarrier::energy(const std::vector<double>& uv) const {
  double sum = 0;
  for (const Contact& c : contacts(uv)) sum += c.weight * barrierAt(c.distance / c.reach).value;
  return sum;
}

void BoundaryBarrier::addDerivatives(const std::vector<double>& uv, Eigen::VectorXd& gradient,
                                     SparseEntries& hessian) const {
  for (const Contact& c : contacts(uv)) {
    const double x = c.distance / c.reach;
    BarrierValue at = barrierAt(x);
    // Hardly any of the contacts that start at rounding distance are under pressure, so one step
    // may take them to more than twice their distance.
    at.curvature *= std::min(1.0, 2 * x);
    c.addBarrier(at, c.reach, c.weight, gradient, hessian);
  }
}

}  // namespace abflat
