#include "solve/kkt_step_solver.h"

#include "solve/minres.h"
#include "solve/nonsymmetric_solve.h"
#include "solve/symmlq.h"

namespace abflat {
namespace {

/// A step with a larger relative residual is not worth taking; a smaller one is an inexact step.
constexpr double kUsableResidual = 0.1;

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

}  // namespace

KktStepSolver::KktStepSolver(const AngleProblem& problem, const KktOptions& options)
    : options_(options), rows_(numberRows(problem)) {
  if (options.precondition) preconditioner_ = std::make_unique<KktPreconditioner>(problem, rows_);
}

bool KktStepSolver::step(const NewtonPoint& at, std::vector<double>& dx, Multipliers& next) {
  iterations_ = 0;
  const KktSystem kkt = buildKkt(at, rows_, options_.formulation);
  LinearOperator preconditioner;
  if (preconditioner_) {
    if (!preconditioner_->factor(at.lin, at.active, kkt.rowScale)) return false;
    preconditioner = [this](const Eigen::VectorXd& in, Eigen::VectorXd& out) {
      preconditioner_->apply(in, out);
    };
  }
  const LinearSolveResult r =
      solveWith(options_.solver, kkt, {options_.tolerance, options_.maxIterations}, preconditioner);
  iterations_ = r.iterations;
  if (!r.x.allFinite() || !(r.residual <= kUsableResidual)) return false;
  const double* x = r.x.data();
  const std::size_t corners = at.angles.size(), triangles = corners / 3;
  dx.assign(x, x + corners);
  next.triangle.assign(x + corners, x + corners + triangles);
  next.row.assign(x + corners + triangles, x + r.x.size());
  for (std::size_t i = 0; i < next.row.size(); ++i) next.row[i] *= kkt.rowScale[i];
  return true;
}

}  // namespace abflat
