#include "reproduce/convergence.h"

#include <algorithm>
#include <sstream>

#include "abflat/draw.h"
#include "abflat/flatten.h"

namespace abflat::cli {
namespace {

/// The largest meshes that a solver handles in seconds, not minutes: with a preconditioner; the
/// symmetric solvers without one; and GMRES and BiCGSTAB without one, which take 17 s where MINRES
/// takes 0.1 s.
constexpr std::size_t kMaxFaces = 5000, kMaxFacesPlain = 2000, kMaxFacesPlainUnsymmetric = 600;

struct Method {
  LinearSolver solver;
  Formulation formulation;
};

/// The paper's solvers with its form of the wheel condition, and those of classic ABF with theirs.
constexpr Method kMethods[] = {{LinearSolver::Schur, Formulation::Log},
                               {LinearSolver::Minres, Formulation::Log},
                               {LinearSolver::Symmlq, Formulation::Log},
                               {LinearSolver::Gmres, Formulation::Product},
                               {LinearSolver::Bicgstab, Formulation::Product}};

bool isIterative(const Method& m) { return m.solver != LinearSolver::Schur; }

std::size_t mostFaces(const Method& m, bool precondition) {
  const bool isSymmetric = m.solver == LinearSolver::Minres || m.solver == LinearSolver::Symmlq;
  if (precondition) return kMaxFaces;
  return isSymmetric ? kMaxFacesPlain : kMaxFacesPlainUnsymmetric;
}

std::string nameOf(const Method& m) {
  return std::string(nameOf(m.solver)) + ", " + nameOf(m.formulation);
}

std::string threeDigits(double value) {
  std::ostringstream out;
  out.precision(3);
  out << value;
  return out.str();
}

std::vector<Cell> commonCells(const Experiment& e, const Method& m, bool precondition) {
  return {e.model().name, e.summary().triangles, nameOf(m.solver), nameOf(m.formulation),
          !isIterative(m) ? ""
          : precondition  ? "yes"
                          : "no"};
}

/// Linear iterations, over all steps.
int totalIterations(const ChartReport& c) {
  int out = 0;
  for (const NewtonStep& s : c.history) out += s.linearIterations;
  return out;
}

/// Returns an empty string, or why the history does not belong to the method.
std::string strayed(const ChartReport& c, const Method& m) {
  if (c.linearSolver == m.solver && c.formulation == m.formulation) return "";
  return std::string("did not converge; fell back to ") + nameOf(c.solver) + " with " +
         nameOf(c.linearSolver);
}

/// The curves of one mesh, each with a line in the legend.
struct Plot {
  std::vector<Curve> constraint, gradient, iterations;
  std::vector<std::string> legend;

  void add(const Method& m, const std::vector<NewtonStep>& history, const std::string& text) {
    Curve c, g, n;
    for (const NewtonStep& s : history) {
      c.y.push_back(s.constraint);
      g.y.push_back(s.gradient);
      if (isIterative(m)) n.y.push_back(s.linearIterations);
    }
    constraint.push_back(c);
    gradient.push_back(g);
    iterations.push_back(n);
    legend.push_back(nameOf(m) + ": " + text);
  }
};

class Runs {
 public:
  Runs(Table& table, Experiment& experiment, bool precondition)
      : table_(table), experiment_(experiment), precondition_(precondition) {}

  void run(const Method& m) {
    const std::size_t faces = experiment_.summary().triangles;
    const std::size_t most = mostFaces(m, precondition_);
    if (isIterative(m) && faces > most)
      return leaveOut(m, "left out: " + std::to_string(faces) + " faces; the limit is " +
                             std::to_string(most) +
                             (precondition_ ? "" : " without preconditioner"));
    if (isIterative(m) && stalls_)
      return leaveOut(m, "left out: on this mesh the active set stalls with exact steps as well");
    FlattenOptions options;
    options.threads = 1;  // some linear solvers only have one
    options.t = 1;
    options.linearSolver = m.solver;
    options.formulation = m.formulation;
    options.precondition = precondition_;
    const Result<FlattenResult> result = experiment_.flattenedWith(options);
    if (!result.ok()) return leaveOut(m, result.status().message);
    const ChartReport& c = result.value().report.charts.front();
    if (const std::string why = strayed(c, m); !why.empty()) return leaveOut(m, why);
    if (!isIterative(m)) stalls_ = c.solver != Solver::ActiveSet;
    addSteps(m, c, secondsOf(result.value().report));
  }

  const Plot& plot() const { return plot_; }

 private:
  void leaveOut(const Method& m, const std::string& reason) {
    std::vector<Cell> row = commonCells(experiment_, m, precondition_);
    row.resize(table_.columns.size());
    row.back() = Cell(reason);
    table_.rows.push_back(row);
    plot_.add(m, {}, reason);
  }

  void addSteps(const Method& m, const ChartReport& c, double seconds) {
    for (std::size_t i = 0; i < c.history.size(); ++i) {
      const NewtonStep& s = c.history[i];
      std::vector<Cell> row = commonCells(experiment_, m, precondition_);
      for (const Cell& cell :
           std::initializer_list<Cell>{nameOf(c.solver),
                                       i + 1,
                                       {s.objective, 6},
                                       Cell(s.constraint, 12),
                                       {s.gradient, 12},
                                       std::size_t{s.active},
                                       {s.step, 4},
                                       static_cast<std::size_t>(s.linearIterations),
                                       {s.linearSeconds, 4},
                                       {seconds, 4},
                                       ""})
        row.push_back(cell);
      table_.rows.push_back(row);
    }
    const int iterations = totalIterations(c);
    plot_.add(m, c.history,
              std::to_string(c.history.size()) + " steps" +
                  (isIterative(m) ? ", " + std::to_string(iterations) + " iterations" : "") + ", " +
                  threeDigits(seconds) + " s" +
                  (c.solver == Solver::ActiveSet ? "" : ", by the interior point"));
  }

  Table& table_;
  Experiment& experiment_;
  bool precondition_;
  bool stalls_ = false;  ///< the first method, which is direct, needed the interior point
  Plot plot_;
};

}  // namespace

Table emptyConvergence() {
  return {{{"mesh", true},
           {"faces"},
           {"linear solver", true},
           {"formulation", true},
           {"preconditioned", true},
           {"solver", true},
           {"step"},
           {"objective"},
           {"constraint"},
           {"gradient"},
           {"active"},
           {"step length"},
           {"linear iterations"},
           {"linear seconds"},
           {"total seconds"},
           {"remark", true}},
          {}};
}

std::string addConvergence(Table& table, Experiment& e, bool precondition) {
  if (!e.status().ok()) return "";
  Runs runs(table, e, precondition);
  for (const Method& m : kMethods) runs.run(m);
  const Plot& plot = runs.plot();
  const std::string heading = e.model().name + ": convergence at t = 1, " +
                              std::to_string(e.summary().triangles) + " faces, iterative solvers " +
                              (precondition ? "with" : "without") + " preconditioner";
  return svgFile(
      heading,
      {drawLogPlot(plot.constraint, {"Constraint residual (radians)", "Newton step"}),
       drawLogPlot(plot.gradient, {"Gradient of the Lagrangian (relative)", "Newton step"}),
       drawLogPlot(plot.iterations, {"Iterations of the linear solver", "Newton step"}),
       drawLegend(plot.legend, 900)},
      3);
}

}  // namespace abflat::cli
