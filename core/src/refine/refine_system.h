#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "chart/disk_chart.h"
#include "refine/rest_triangles.h"

namespace abflat {

/// The gradient of a layout's energy and the matrix of projected Newton: two rows a vertex, u and
/// v, in a pattern that never changes.
class RefineSystem {
 public:
  /// Keeps references.
  RefineSystem(const DiskChart& chart, const std::vector<RestTriangle>& rest);

  /// Rows of vertices that are `isFixed` become identity rows with gradient 0; empty: none.
  void assemble(double balance, const std::vector<double>& uv,
                const std::vector<std::uint8_t>& isFixed);

  /// Afterwards: adds what pulls a vertex back that leaves its place along (x, y).
  void pull(std::uint32_t vertex, double x, double y, double stiffness);

  /// Lower triangle by columns.
  const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }
  const Eigen::VectorXd& gradient() const { return gradient_; }

 private:
  void buildPattern();
  void addTriangle(std::uint32_t f, double balance, const std::vector<double>& uv);
  void fix(const std::vector<std::uint8_t>& isFixed);

  const DiskChart& chart_;
  const std::vector<RestTriangle>& rest_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::VectorXd gradient_;
  /// Per half-edge: where the values have the row u of its later vertex and the column u of its
  /// earlier one.
  std::vector<std::uint32_t> entryOfEdge_;
};

}  // namespace abflat
