#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace abflat {

/// Undirected graph without loops; every edge is stored at both ends.
struct WeightedGraph {
  std::vector<std::size_t> offset;       ///< size V+1
  std::vector<std::uint32_t> neighbour;  ///< size offset.back(), ascending within a vertex
  std::vector<std::uint32_t> weight;     ///< matrix rows a vertex stands for

  std::uint32_t size() const { return static_cast<std::uint32_t>(weight.size()); }
  const std::uint32_t* begin(std::uint32_t v) const { return neighbour.data() + offset[v]; }
  const std::uint32_t* end(std::uint32_t v) const { return neighbour.data() + offset[v + 1]; }
  std::uint32_t degree(std::uint32_t v) const {
    return static_cast<std::uint32_t>(offset[v + 1] - offset[v]);
  }
};

/// Lower triangle of a symmetric matrix by columns, as Eigen::SparseMatrix<double> stores it. Rows
/// ascend within a column; entries above the diagonal are ignored.
struct LowerPattern {
  std::uint32_t rows = 0;
  const int* columnStart = nullptr;  ///< size rows + 1
  const int* row = nullptr;
};

/// Graph of the matrix in which neighbouring rows of the same structure are one vertex: everything
/// symbolic is done once for them.
struct CompressedGraph {
  WeightedGraph graph;
  std::vector<std::uint32_t> firstRow;  ///< vertex v has the rows firstRow[v] to firstRow[v+1]
};
CompressedGraph compressGraph(const LowerPattern& pattern);

}  // namespace abflat
