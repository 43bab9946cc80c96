#include "research/kkt_step_solver.h"

#include <algorithm>

#include "research/minres.h"
#include "research/nonsymmetric_solve.h"
#include "research/symmlq.h"

namespace abflat {
namespace {

/// A step with a larger relative residual is not worth taking; a smaller one is an inexact step.
constexpr double kUsableResidual = 0.1;

/// Without rounding each method would end after as many iterations as there are rows. With a
/// preconditioner a small part of that is enough; without one, rounding makes it several times as
/// many.
int iterationLimit(Eigen::Index rows, bool isPreconditioned, int most) {
  constexpr Eigen::Index kFew = 100, kWithout = 8;
  const Eigen::Index limit = isPreconditioned ? kFew + rows : kWithout * rows;
  return static_cast<int>(std::min<Eigen::Index>(limit, most));
}

LinearSolveResult solveWith(LinearSolver solver, const KktSystem& kkt,
                            const LinearSolveOptions& options,
                            const LinearOperator& preconditioner) {
  if (solver == LinearSolver::Gmres) return gmres(kkt.matrix, kkt.rhs, options, preconditioner);
  if (solver == LinearSolver::Bicgstab)
    return bicgstab(kkt.matrix, kkt.rhs, options, preconditioner);
  const LinearOperator matrix = [&](const Eigen::VectorXd& in, Eigen::VectorXd& out) {
    out.noalias() = kkt.matrix * in;
  };
  return solver == LinearSolver::Symmlq ? symmlq(matrix, kkt.rhs, options, preconditioner)
                                        : minres(matrix, kkt.rhs, options, preconditioner);
}

/// The multipliers of the point as the system scales them, below zeros for dx.
Eigen::VectorXd oldMultipliers(const NewtonPoint& at, const KktSystem& kkt) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(kkt.rhs.size());
  auto i = static_cast<Eigen::Index>(at.angles.size());
  for (const double m : at.multipliers.triangle) out[i++] = m;
  for (std::size_t r = 0; r < at.multipliers.row.size(); ++r)
    out[i++] = at.multipliers.row[r] / kkt.rowScale[r];
  return out;
}

}  // namespace

KktStepSolver::KktStepSolver(const AngleProblem& problem, const KktOptions& options)
    : options_(options), rows_(numberRows(problem)) {
  if (options.precondition) preconditioner_ = std::make_unique<KktPreconditioner>(problem, rows_);
}

bool KktStepSolver::step(const NewtonPoint& at, std::vector<double>& dx, Multipliers& next) {
  iterations_ = 0;
  KktSystem kkt = buildKkt(at, rows_, options_.formulation);
  // Solved for the change of the multipliers: the right-hand side then shrinks with the error, and
  // a relative tolerance with it.
  const Eigen::VectorXd old = oldMultipliers(at, kkt);
  kkt.rhs -= kkt.matrix * old;
  LinearOperator preconditioner;
  if (preconditioner_) {
    if (!preconditioner_->factor(at.lin, at.active, kkt.rowScale)) return false;
    preconditioner = [this](const Eigen::VectorXd& in, Eigen::VectorXd& out) {
      preconditioner_->apply(in, out);
    };
  }
  const int limit = iterationLimit(kkt.rhs.size(), options_.precondition, options_.maxIterations);
  LinearSolveResult r =
      solveWith(options_.solver, kkt, {options_.tolerance, limit}, preconditioner);
  iterations_ = r.iterations;
  if (!r.x.allFinite() || !(r.residual <= kUsableResidual)) return false;
  r.x += old;
  const double* x = r.x.data();
  const std::size_t corners = at.angles.size(), triangles = corners / 3;
  dx.assign(x, x + corners);
  next.triangle.assign(x + corners, x + corners + triangles);
  next.row.assign(x + corners + triangles, x + r.x.size());
  for (std::size_t i = 0; i < next.row.size(); ++i) next.row[i] *= kkt.rowScale[i];
  return true;
}

}  // namespace abflat
