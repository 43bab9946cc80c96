#include "refine/objective.h"

#include <cmath>

#include "refine/layout_energy.h"

namespace abflat {

Objective::Objective(const DiskChart& ofChart, const std::vector<double>& uv,
                     const RefineOptions& options)
    : chart(ofChart),
      energy(options.energy),
      rest(restTriangles(ofChart, uv)),
      shape(ofChart, options.outline),
      springs(options.level),
      pool(options.pool) {}

double Objective::ofLayout(const std::vector<double>& uv) const {
  return layoutEnergy(chart, rest, energy, uv, pool);
}

double Objective::at(const std::vector<double>& uv) const {
  const double own = ofLayout(uv);
  if (!std::isfinite(own)) return own;
  return own + shape.energy(uv) + springs.energy(uv) + (barrier ? barrier->energy(uv) : 0);
}

void Objective::addOutlineDerivatives(const std::vector<double>& uv, Eigen::VectorXd& gradient,
                                      SparseEntries& hessian) const {
  shape.addDerivatives(uv, gradient, hessian);
  springs.addDerivatives(uv, gradient, hessian);
  if (barrier) barrier->addDerivatives(uv, gradient, hessian);
}

}  // namespace abflat
