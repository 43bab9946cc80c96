// Where the time of one mesh goes, stage by stage and within a Newton step, and how many iterations
// conjugate gradients would take in place of a factorisation.
//
//   abflat_profile_bench FILE.obj [T]
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "abflat/io.h"
#include "angle/angle_problem.h"
#include "base/stopwatch.h"
#include "chart/disk_chart.h"
#include "check/crossings.h"
#include "check/distortion.h"
#include "check/validity.h"
#include "layout/layout.h"
#include "mesh/surface.h"
#include "solve/angle_solver.h"
#include "solve/cholesky/cholesky.h"
#include "solve/conjugate_gradients.h"
#include "solve/schur_system.h"

using namespace abflat;

namespace {

void tell(const char* what, Stopwatch& watch) {
  std::printf("  %-44s %9.4f s\n", what, watch.lap());
  watch.lap();
}

class FactorPreconditioner : public Preconditioner {
 public:
  explicit FactorPreconditioner(const FloatCholesky& factor) : factor_(factor) {}
  void apply(const double* r, double* z) const override {
    std::copy_n(r, factor_.symbolic().size, z);
    factor_.solve(z);
  }

 private:
  const FloatCholesky& factor_;
};

/// Iterations until the residual is `share` of the right-hand side, with the factor of another
/// matrix; 200 when they are not enough.
int iterations(const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& b,
               const FloatCholesky& factor, double share) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  const double tolerance = share * b.lpNorm<Eigen::Infinity>();
  return conjugateGradients(lower, b, FactorPreconditioner(factor), x, {tolerance, 200}).iterations;
}

void profileSystem(const AngleProblem& problem, const AngleSolution& solution) {
  Stopwatch watch;
  const ConstraintRows rows = numberRows(problem);
  SchurSystem schur(problem, rows);
  tell("pattern and scatter of the system", watch);
  const Eigen::SparseMatrix<double>& m = schur.matrix();
  const LowerPattern pattern{rows.count(), m.outerIndexPtr(), m.innerIndexPtr()};
  const CompressedGraph graph = compressGraph(pattern);
  tell("ordering: graph of the pattern", watch);
  nestedDissection(graph.graph, {});
  tell("ordering: nested dissection", watch);
  const auto symbolic = std::make_shared<const CholeskySymbolic>(analyzePattern(pattern));
  tell("whole analysis, ordering included", watch);
  Linearization lin;
  const std::vector<double> noMultipliers(rows.count(), 0.0);
  linearize(problem, rows, {problem.target.raw(), noMultipliers, Curvature::Clamped}, lin);
  tell("linearize, one step", watch);
  const std::vector<std::uint8_t> none(problem.isBoundary.size(), 0);
  schur.assemble(lin, none);
  tell("assemble, one step", watch);
  Cholesky factor(symbolic);
  const bool isFactored = factor.factorize(m.valuePtr()).isOk();
  tell("numeric factorisation, first (allocates)", watch);
  if (!isFactored || !factor.factorize(m.valuePtr()).isOk()) return;
  tell("numeric factorisation, further", watch);
  std::vector<double> x(schur.rightHandSide().begin(), schur.rightHandSide().end());
  factor.solve(x.data());
  tell("substitution, one right-hand side", watch);
  FloatCholesky inSingle(symbolic);
  if (!inSingle.factorize(m.valuePtr()).isOk()) return;
  tell("single precision: first, allocates", watch);
  if (!inSingle.factorize(m.valuePtr()).isOk()) return;
  tell("single precision: further", watch);
  inSingle.solve(x.data());
  tell("single precision: substitution", watch);
  const Eigen::VectorXd product = m.selfadjointView<Eigen::Lower>() * schur.rightHandSide();
  tell("matrix times vector", watch);
  Multipliers multipliers;
  std::vector<double> dx;
  schur.backSubstitute(lin, x, dx, multipliers.triangle);
  tell("angles from the rows", watch);
  linearize(problem, rows, {solution.angles, solution.multipliers.row, Curvature::Exact}, lin);
  schur.assemble(lin, none);
  for (const double share : {1e-2, 1e-4, 1e-8})
    std::printf("  conjugate gradients at the solution, factor of the first step, to %g: %d\n",
                share, iterations(m, product, inSingle, share));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: abflat_profile_bench FILE.obj [T]\n", stderr);
    return 2;
  }
  Stopwatch watch;
  std::ifstream in(argv[1], std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  watch.lap();
  Result<PolygonMesh> mesh = readMesh(bytes, MeshFormat::Obj, argv[1]);
  if (!in || !mesh.ok()) {
    std::fprintf(stderr, "%s cannot be read\n", argv[1]);
    return 1;
  }
  tell("parse", watch);
  const Surface surface = buildSurface(mesh.value());
  tell("connectivity and verdict", watch);
  if (!surface.summary.disk.ok()) {
    std::fprintf(stderr, "%s\n", surface.summary.disk.message.c_str());
    return 1;
  }
  const DiskChart chart = makeDiskChart(mesh.value(), surface);
  tell("chart", watch);
  AngleProblem problem = buildAngleProblem(chart);
  setBounds(problem, chart,
            BoundaryBounds(chart.boundary.size(), argc > 2 ? std::atof(argv[2]) : 2.0));
  tell("angle problem", watch);
  AngleSolver solver(problem, {});
  tell("solver: pattern and analysis", watch);
  const AngleSolution solution = solver.solve(nullptr);
  double linear = 0;
  for (const NewtonStep& step : solution.history) linear += step.linearSeconds;
  std::printf("  %zu steps, %.4f s of them in the linear system\n", solution.history.size(),
              linear);
  tell("solver: all steps", watch);
  const std::vector<double> uv = layOut(chart, solution.angles);
  tell("layout", watch);
  const Validity validity = checkValidity(chart, uv);
  tell(validity.valid() ? "validity: valid" : "validity: NOT valid", watch);
  findCrossings(boundaryUv(chart, uv));
  tell("  of it crossings of the boundary", watch);
  measureDistortion(chart, uv);
  tell("distortion, once", watch);
  profileSystem(problem, solution);
  return 0;
}
