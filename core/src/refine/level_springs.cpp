#include "refine/level_springs.h"

#include <algorithm>

namespace abflat {
namespace {

struct Spring {
  std::uint32_t from, to;  ///< rows
  double stretch;
};

Spring springOf(const LevelEdge& edge, const std::vector<double>& uv) {
  const std::uint32_t from = 2 * edge.from + edge.across, to = 2 * edge.to + edge.across;
  return {from, to, uv[to] - uv[from]};
}

}  // namespace

LevelSprings::LevelSprings(const LevelEdges& level) : edges_(level.edges) {
  double length = 0;
  for (const LevelEdge& edge : edges_) length += edge.length;
  if (length > 0) strength_ = level.stiffness / length;
}

double LevelSprings::energy(const std::vector<double>& uv) const {
  double sum = 0;
  for (const LevelEdge& edge : edges_) {
    const Spring spring = springOf(edge, uv);
    sum += strength_ / edge.length * spring.stretch * spring.stretch;
  }
  return sum;
}

void LevelSprings::addDerivatives(const std::vector<double>& uv, Eigen::VectorXd& gradient,
                                  SparseEntries& hessian) const {
  for (const LevelEdge& edge : edges_) {
    const Spring spring = springOf(edge, uv);
    const double curvature = 2 * strength_ / edge.length;
    gradient[spring.from] -= curvature * spring.stretch;
    gradient[spring.to] += curvature * spring.stretch;
    const auto [low, high] = std::minmax(spring.from, spring.to);
    for (const std::uint32_t row : {low, high})
      hessian.emplace_back(static_cast<int>(row), static_cast<int>(row), curvature);
    hessian.emplace_back(static_cast<int>(high), static_cast<int>(low), -curvature);
  }
}

}  // namespace abflat
