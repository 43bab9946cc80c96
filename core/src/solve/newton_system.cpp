#include "solve/newton_system.h"

namespace abflat {

NewtonSystem::NewtonSystem(const AngleProblem& problem)
    : rows_(numberRows(problem)), schur_(problem, rows_) {
  factor_.analyzePattern(schur_.matrix());
}

bool NewtonSystem::solve(const Linearization& lin, const std::vector<std::uint8_t>& active,
                         const std::vector<double>& compliance, std::vector<double>& dx,
                         Multipliers& multipliers) {
  schur_.assemble(lin, active, compliance);
  factor_.factorize(schur_.matrix());
  if (factor_.info() != Eigen::Success) return false;
  const Eigen::VectorXd solved = factor_.solve(schur_.rightHandSide());
  multipliers.row.assign(solved.begin(), solved.end());
  schur_.backSubstitute(lin, multipliers.row, dx, multipliers.triangle);
  return true;
}

}  // namespace abflat
