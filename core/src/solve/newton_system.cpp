#include "solve/newton_system.h"

namespace abflat {
namespace {

/// Per row, the rank of its vertex.
std::vector<std::uint32_t> rankOfRows(const AngleProblem& problem, const ConstraintRows& rows) {
  std::vector<std::uint32_t> out;
  for (const ChartVertex v : problem.eliminationRank.ids())
    out.insert(out.end(), rows.ofVertex[v + 1] - rows.ofVertex[v], problem.eliminationRank[v]);
  return out;
}

}  // namespace

NewtonSystem::NewtonSystem(const AngleProblem& problem, MakeRowSolver& makeSolver, ThreadPool* pool)
    : rows_(numberRows(problem)),
      schur_(problem, rows_, pool),
      solver_(makeSolver(schur_.matrix(), pool)) {
  if (solver_->eliminationRank()) schur_.divide(*solver_->eliminationRank());
}

NewtonSystem::NewtonSystem(const AngleProblem& problem, std::uint64_t allowedBytes,
                           ThreadPool* pool)
    : rows_(numberRows(problem)),
      schur_(problem, rows_, pool),
      memory_{allowedBytes},
      solver_(makeRowSolverWithin(schur_.matrix(), rowKinds(rows_), memory_, pool,
                                  rankOfRows(problem, rows_))) {
  if (solver_->eliminationRank()) schur_.divide(*solver_->eliminationRank());
}

IdVector<ChartVertex, std::uint32_t> NewtonSystem::eliminationRank() const {
  IdVector<ChartVertex, std::uint32_t> out;
  if (const std::vector<std::uint32_t>* ofRow = solver_->eliminationRank())
    for (std::size_t v = 0; v + 1 < rows_.ofVertex.size(); ++v)
      out.push_back((*ofRow)[rows_.ofVertex[v]]);
  return out;
}

bool NewtonSystem::step(const NewtonPoint& at, std::vector<double>& dx, Multipliers& next) {
  schur_.assemble(at.lin, at.active);
  x_ = Eigen::Map<const Eigen::VectorXd>(at.multipliers.row.data(), rows_.count());
  for (const ChartVertex v : at.problem.vertices())
    if (at.problem.isBoundary[v] && !at.active[v]) x_[rows_.ofVertex[v]] = 0;
  if (!solver_->solve(schur_.matrix(), schur_.rightHandSide(), at.tolerance, x_)) return false;
  next.row.assign(x_.begin(), x_.end());
  schur_.backSubstitute(at.lin, next.row, dx, next.triangle);
  return true;
}

bool NewtonSystem::solve(const Linearization& lin, const std::vector<std::uint8_t>& active,
                         const std::vector<double>& compliance, std::vector<double>& dx,
                         Multipliers& multipliers) {
  schur_.assemble(lin, active, compliance);
  x_.setZero(rows_.count());
  if (!solver_->solve(schur_.matrix(), schur_.rightHandSide(), 0, x_)) return false;
  multipliers.row.assign(x_.begin(), x_.end());
  schur_.backSubstitute(lin, multipliers.row, dx, multipliers.triangle);
  return true;
}

}  // namespace abflat
