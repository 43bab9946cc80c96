#include "research/kkt_system.h"

#include <cmath>

#include "research/wheel_product.h"

namespace abflat {
namespace {

class KktBuilder {
 public:
  KktBuilder(const NewtonPoint& at, const ConstraintRows& rows, Formulation formulation)
      : at_(at),
        rows_(rows),
        corners_(at.problem.vertexOfCorner.size()),
        triangles_(at.problem.triangleCount()) {
    const auto n = static_cast<Eigen::Index>(corners_ + triangles_ + rows.count());
    out_.rhs.setZero(n);
    out_.rowScale.assign(rows.count(), 1);
    if (formulation == Formulation::Product) wheels_ = wheelProducts(at.problem, at.angles);
  }

  KktSystem build() {
    addTriangles();
    addBoundaryAndWheels();
    if (!wheels_.empty()) addWheelHessians();
    out_.matrix = assembled(out_.rhs.size());
    return std::move(out_);
  }

 private:
  void add(std::size_t r, std::size_t c, double value) {
    entries_.emplace_back(static_cast<int>(r), static_cast<int>(c), value);
  }
  void addPair(std::size_t r, std::size_t c, double value) {
    add(r, c, value);
    add(c, r, value);
  }
  Eigen::SparseMatrix<double> assembled(Eigen::Index n) const {
    if (n == 0) return {};
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return matrix;
  }
  std::size_t place(std::uint32_t row) const { return corners_ + triangles_ + row; }
  bool isOff(ChartVertex v) const { return at_.problem.isBoundary[v] && !at_.active[v]; }

  void addTriangles() {
    for (const ChartTriangle f : at_.problem.triangles()) {
      const Element& e = at_.lin.elements[f];
      out_.rhs[static_cast<Eigen::Index>(corners_ + f)] = -e.triangleResidual;
      for (std::size_t k = 0; k < 3; ++k) {
        const ChartCorner c = cornerOf(f, k), n = nextCorner(c), p = prevCorner(c);
        const ChartVertex v = at_.problem.vertexOfCorner[c];
        add(c, c, wheels_.empty() ? e.hessian[k] : 2 * at_.problem.weight[c]);
        out_.rhs[c] = -e.gradient[k];
        addPair(c, corners_ + f, 1);
        if (isOff(v)) continue;
        addPair(c, place(rows_.ofVertex[v]), 1);
        if (at_.problem.isBoundary[v]) continue;
        const std::size_t wheel = place(rows_.ofVertex[v] + 1);
        addPair(n, wheel, e.cot[(k + 1) % 3] * (wheels_.empty() ? 1 : wheels_[v].next));
        addPair(p, wheel, -e.cot[(k + 2) % 3] * (wheels_.empty() ? 1 : wheels_[v].prev));
      }
    }
  }

  void addBoundaryAndWheels() {
    for (const ChartVertex v : at_.problem.vertices()) {
      const std::uint32_t r = rows_.ofVertex[v];
      if (isOff(v)) {
        add(place(r), place(r), 1);
        continue;
      }
      out_.rhs[static_cast<Eigen::Index>(place(r))] = -at_.lin.residual[r];
      if (at_.problem.isBoundary[v]) continue;
      double value = at_.lin.residual[r + 1];
      if (!wheels_.empty()) {
        value = wheels_[v].value();
        out_.rowScale[r + 1] = std::sqrt(wheels_[v].next * wheels_[v].prev);
      }
      out_.rhs[static_cast<Eigen::Index>(place(r + 1))] = -value;
    }
  }

  void addWheelHessians() {
    std::vector<double> cot(corners_);
    for (const ChartCorner c : at_.problem.corners())
      cot[c] = at_.lin.elements[triangleOf(c)].cot[placeInTriangle(c)];
    const VertexCorners fans = cornersOfVertices(at_.problem);
    for (const ChartVertex v : at_.problem.vertices()) {
      if (at_.problem.isBoundary[v]) continue;
      const std::uint32_t r = rows_.ofVertex[v] + 1;
      const double multiplier = at_.multipliers.row[r] / out_.rowScale[r];
      forEachSecondDerivative(
          fans, cot, wheels_[v], v,
          [&](ChartCorner i, ChartCorner j, double value) { add(i, j, multiplier * value); });
    }
  }

  const NewtonPoint& at_;
  const ConstraintRows& rows_;
  const std::size_t corners_, triangles_;
  WheelProducts wheels_;  ///< empty: logarithmic form
  std::vector<Eigen::Triplet<double>> entries_;
  KktSystem out_;
};

}  // namespace

KktSystem buildKkt(const NewtonPoint& at, const ConstraintRows& rows, Formulation formulation) {
  return KktBuilder(at, rows, formulation).build();
}

}  // namespace abflat
