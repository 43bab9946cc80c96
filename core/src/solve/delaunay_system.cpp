#include "solve/delaunay_system.h"

#include "mesh/corner_table.h"

namespace abflat {
namespace {

/// Active edges may depend on each other. This much of the multipliers' change is added to their
/// rows: the system stays regular, and the solution of a converged iteration is the same.
constexpr double kProximal = 1e-9;

/// The rows of the constraints' derivatives by a triangle's three angles: sums and wheels of its
/// vertices as in Element, then the edge opposite each corner.
std::array<std::array<double, 3>, 9> jacobian(const Element& e) {
  std::array<std::array<double, 3>, 9> b{};
  for (unsigned k = 0; k < 3; ++k) {
    b[2 * k][k] = 1;
    b[2 * k + 1][(k + 1) % 3] = e.cot[(k + 1) % 3];
    b[2 * k + 1][(k + 2) % 3] = -e.cot[(k + 2) % 3];
    b[6 + k][k] = 1;
  }
  return b;
}

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

bool DelaunaySystem::step(const NewtonPoint& at, std::vector<double>& dx, Multipliers& next) {
  numberEdges(at.activeEdge);
  assemble(at);
  const std::pair<Flags, Flags> pattern(at.active, at.activeEdge);
  if (!solver_ || analyzedFor_ != pattern) {
    solver_ = makeDirectRowSolver(matrix_, nullptr);
    analyzedFor_ = pattern;
  }
  Eigen::VectorXd solved;
  if (!solver_->solve(matrix_, rhs_, 0, solved)) return false;
  next.row.assign(solved.data(), solved.data() + rows_.count());
  next.edge.assign(rowOfEdge_.size(), 0);
  for (std::size_t i = 0; i < rowOfEdge_.size(); ++i)
    if (rowOfEdge_[i] != kNone) next.edge[i] = solved[rowOfEdge_[i]];
  backSubstitute(at, dx, next);
  return true;
}

void DelaunaySystem::numberEdges(const std::vector<std::uint8_t>& activeEdge) {
  rowOfEdge_.assign(activeEdge.size(), kNone);
  count_ = rows_.count();
  for (std::size_t i = 0; i < activeEdge.size(); ++i)
    if (activeEdge[i]) rowOfEdge_[i] = count_++;
}

DelaunaySystem::LocalRows DelaunaySystem::localRows(const NewtonPoint& at, ChartTriangle f) const {
  LocalRows out;
  for (std::size_t k = 0; k < 3; ++k) {
    const ChartVertex v = problem_.vertexOfCorner[cornerOf(f, k)];
    const std::uint32_t r = rows_.ofVertex[v], edge = problem_.edgeOfCorner[cornerOf(f, k)];
    out[2 * k] = problem_.isBoundary[v] && !at.active[v] ? kNone : r;
    out[2 * k + 1] = problem_.isBoundary[v] ? kNone : r + 1;
    out[6 + k] = edge == kNone ? kNone : rowOfEdge_[edge];
  }
  return out;
}

void DelaunaySystem::assemble(const NewtonPoint& at) {
  entries_.clear();
  rhs_.setZero(count_);
  for (const ChartTriangle f : problem_.triangles()) {
    const Element& e = at.lin.elements[f];
    const LocalRows row = localRows(at, f);
    const auto b = jacobian(e);
    std::array<double, 3> z = applyProjected(e, e.gradient);
    const std::array<double, 3> unit = unitStep(e);
    for (unsigned k = 0; k < 3; ++k) z[k] += unit[k] * e.triangleResidual;
    for (unsigned r = 0; r < 9; ++r) {
      if (row[r] == kNone) continue;
      rhs_[row[r]] -= dot(b[r], z);
      const std::array<double, 3> pb = applyProjected(e, b[r]);
      for (unsigned c = 0; c < 9; ++c)
        if (row[c] != kNone && row[c] <= row[r])
          entries_.emplace_back(row[r], row[c], dot(b[c], pb));
    }
  }
  for (const ChartVertex v : problem_.vertices())
    for (std::uint32_t r = rows_.ofVertex[v]; r < rows_.ofVertex[v + 1]; ++r) {
      if (problem_.isBoundary[v] && !at.active[v])
        entries_.emplace_back(r, r, 1);
      else
        rhs_[r] += at.lin.residual[r];
    }
  const double softness = kProximal + problem_.edgeCompliance;
  for (std::size_t i = 0; i < rowOfEdge_.size(); ++i) {
    const std::uint32_t r = rowOfEdge_[i];
    if (r == kNone) continue;
    entries_.emplace_back(r, r, softness);
    rhs_[r] += at.lin.edgeResidual[i] + softness * at.multipliers.edge[i];
  }
  matrix_ = assembled(count_, entries_);
}

void DelaunaySystem::backSubstitute(const NewtonPoint& at, std::vector<double>& dx,
                                    Multipliers& next) const {
  dx.resize(problem_.vertexOfCorner.size());
  next.triangle.resize(problem_.triangleCount());
  for (const ChartTriangle f : problem_.triangles()) {
    const Element& e = at.lin.elements[f];
    std::array<double, 3> z = applyTransposedJacobian(e, gatherRows(problem_, rows_, next.row, f));
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t edge = problem_.edgeOfCorner[cornerOf(f, k)];
      z[k] += e.gradient[k] + (edge == kNone ? 0 : next.edge[edge]);
    }
    const std::array<double, 3> projected = applyProjected(e, z), unit = unitStep(e);
    double& lambda = next.triangle[f];
    lambda = e.triangleResidual * e.hessian[0] * unit[0];
    for (unsigned k = 0; k < 3; ++k) {
      lambda -= unit[k] * z[k];
      dx[cornerOf(f, k)] = -projected[k] - unit[k] * e.triangleResidual;
    }
  }
}

}  // namespace abflat
