#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/parallel.h"
#include "mesh/ids.h"

namespace abflat {

/// What a triangle adds to a system. Local rows: 2k and 2k + 1 of vertex k; the second is ignored
/// if the vertex has only one.
struct TriangleRows {
  std::array<double, 21> matrix;  ///< lower triangle by rows
  std::array<double, 6> rightHandSide;
};

/// A symmetric system with one or two rows per vertex, assembled from triangles into a pattern that
/// never changes.
class RowSystem {
 public:
  /// Keeps a reference to the vertices. `firstRow`: per vertex, then the number of rows. `pool`:
  /// null for one thread.
  RowSystem(const IdVector<ChartCorner, ChartVertex>& vertexOfCorner,
            std::vector<std::uint32_t> firstRow, ThreadPool* pool);
  RowSystem(const RowSystem&) = delete;
  RowSystem& operator=(const RowSystem&) = delete;

  /// Divides the assembly among several threads: each gets rows that are adjacent in the given
  /// elimination order, which keeps regions of the mesh together.
  void divide(const std::vector<std::uint32_t>& rankOfRow);

  /// Sets the matrix, and adds to the right-hand side, which the caller sets before. Rows of
  /// vertices marked in `isOff` become identity rows with right-hand side 0; empty: none.
  void assemble(const IdVector<ChartVertex, std::uint8_t>& isOff,
                const std::function<TriangleRows(ChartTriangle)>& rowsOf);

  /// Lower triangle by columns.
  const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }
  /// The entry on the diagonal, followed by the vertex's other row if that is a later one.
  double* diagonal(std::uint32_t row) { return matrix_.valuePtr() + matrix_.outerIndexPtr()[row]; }

  Eigen::VectorXd rightHandSide;

 private:
  void buildPattern();
  void add(const TriangleRows& rows, ChartTriangle f, std::uint32_t region,
           const IdVector<ChartVertex, std::uint8_t>& isOff);

  const IdVector<ChartCorner, ChartVertex>& vertexOfCorner_;
  std::vector<std::uint32_t> firstRow_;
  ThreadPool* pool_;
  Eigen::SparseMatrix<double> matrix_;
  /// Index in the values of the entry in the first row of a half-edge's later vertex and the first
  /// column of its earlier one.
  IdVector<ChartCorner, std::uint32_t> entryOfEdge_;
  /// The region whose thread fills the vertex's rows; empty: not divided.
  IdVector<ChartVertex, std::uint8_t> regionOfVertex_;
  /// Per region, the triangles that contribute to its rows, ascending: each entry is summed in
  /// triangle order, whichever thread does it.
  std::vector<std::vector<ChartTriangle>> triangles_;
};

}  // namespace abflat
