#include "flatten/chosen_solver.h"

#if ABFLAT_RESEARCH
#include "research/kkt_step_solver.h"
#endif

namespace abflat {
namespace {

/// True for the solvers that factor only the matrix of the vertex constraints.
bool isEliminated(LinearSolver solver) {
  return solver == LinearSolver::Schur || solver == LinearSolver::Eigen;
}

#if ABFLAT_RESEARCH
Result<SolverChoice> iterativeSolver(const FlattenOptionValues& options) {
  const KktOptions kkt{options.linearSolver, options.formulation, options.precondition};
  return SolverChoice{kkt.solver, kkt.formulation, [kkt](const AngleProblem& problem) {
                        return std::make_unique<KktStepSolver>(problem, kkt);
                      }};
}
#else
Result<SolverChoice> iterativeSolver(const FlattenOptionValues& options) {
  return Status{StatusCode::InvalidOption,
                std::string("the linear solver ") + nameOf(options.linearSolver) +
                    " is available only in the command line program. Choose schur or eigen"};
}
#endif

}  // namespace

Result<SolverChoice> chosenSolver(const FlattenOptionValues& options) {
  if (!isEliminated(options.linearSolver)) return iterativeSolver(options);
  if (options.formulation == Formulation::Product)
    return Status{StatusCode::InvalidOption,
                  "the product formulation has no Schur elimination, because its Hessian is not "
                  "diagonal. Choose minres, symmlq, gmres or bicgstab as the linear solver"};
  return SolverChoice{options.linearSolver, options.formulation, {}};
}

}  // namespace abflat
