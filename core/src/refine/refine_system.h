#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "base/point2.h"
#include "chart/disk_chart.h"
#include "refine/rest_triangles.h"

namespace abflat {

/// A layout, and which derivatives of its energy are wanted.
struct RefinePoint {
  const std::vector<double>& uv;
  double balance = 0;
  ElementCurvature curvature = ElementCurvature::Near;
};

/// The gradient of a layout's energy and the matrix of projected Newton: two rows a vertex, u and
/// v, in a pattern that never changes.
class RefineSystem {
 public:
  /// Keeps references. `pool`: null for one thread.
  RefineSystem(const DiskChart& chart, const RestTriangles& rest, ThreadPool* pool = nullptr);

  /// For assembling with several threads: each gets rows that are neighbours in the given order of
  /// elimination, which keeps regions of the mesh together.
  void divide(const std::vector<std::uint32_t>& rankOfRow);

  /// Rows of vertices that are `isFixed` become identity rows with gradient 0; empty: none.
  void assemble(const RefinePoint& at, const IdVector<ChartVertex, std::uint8_t>& isFixed);

  /// Afterwards: adds what pulls a vertex back that leaves its place in a direction.
  void pull(ChartVertex vertex, const Point2& direction, double stiffness);

  /// Lower triangle by columns.
  const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }
  const Eigen::VectorXd& gradient() const { return gradient_; }

 private:
  void buildPattern();
  void addTriangle(const RefinePoint& at, ChartTriangle f, std::uint32_t region);
  void fix(const IdVector<ChartVertex, std::uint8_t>& isFixed);

  const DiskChart& chart_;
  const RestTriangles& rest_;
  ThreadPool* pool_;
  /// Whose rows one thread fills; empty: not divided.
  IdVector<ChartVertex, std::uint8_t> regionOfVertex_;
  /// Per region those that contribute to its rows, ascending: each entry is summed in the order of
  /// the triangles, whoever does it.
  std::vector<std::vector<ChartTriangle>> triangles_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::VectorXd gradient_;
  /// Where the values have the row u of a half-edge's later vertex and the column u of its earlier
  /// one.
  IdVector<ChartCorner, std::uint32_t> entryOfEdge_;
};

}  // namespace abflat
