#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "base/point2.h"
#include "chart/disk_chart.h"
#include "refine/element_energy.h"
#include "refine/rest_triangles.h"

namespace abflat {

/// A layout, and which derivatives of its energy to compute.
struct RefinePoint {
  const std::vector<double>& uv;
  const Energy& energy;
  ElementCurvature curvature = ElementCurvature::Near;
};

/// The gradient of a layout's energy and the matrix of projected Newton: two rows per vertex, u and
/// v, in a pattern that never changes.
class RefineSystem {
 public:
  /// Keeps references to the chart and the rest triangles. `pool`: null for one thread.
  RefineSystem(const DiskChart& chart, const RestTriangles& rest, ThreadPool* pool = nullptr);

  /// Divides the assembly among several threads: each gets rows that are adjacent in the given
  /// elimination order, which keeps regions of the mesh together.
  void divide(const std::vector<std::uint32_t>& rankOfRow);

  /// Rows of vertices marked in `isFixed` become identity rows with gradient 0; empty: none.
  void assemble(const RefinePoint& at, const IdVector<ChartVertex, std::uint8_t>& isFixed);

  /// After `assemble`: adds a pull that resists moving a vertex along a direction.
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
  /// The region whose thread fills the vertex's rows; empty: not divided.
  IdVector<ChartVertex, std::uint8_t> regionOfVertex_;
  /// Per region, the triangles that contribute to its rows, ascending: each entry is summed in
  /// triangle order, whichever thread does it.
  std::vector<std::vector<ChartTriangle>> triangles_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::VectorXd gradient_;
  /// Index in the values of the entry in row u of a half-edge's later vertex and column u of its
  /// earlier one.
  IdVector<ChartCorner, std::uint32_t> entryOfEdge_;
};

}  // namespace abflat
