#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace abflat {

/// Gives corners at identical coordinates the same vertex, numbered in the order of their first
/// appearance. -0 is 0.
class VertexTable {
 public:
  explicit VertexTable(std::size_t expectedVertices);

  /// The vertex at finite coordinates.
  std::uint32_t vertexAt(double x, double y, double z);

  std::vector<double> takePositions() { return std::move(positions_); }

 private:
  void grow();

  std::vector<double> positions_;     ///< xyz per vertex
  std::vector<std::uint32_t> slots_;  ///< vertex + 1, or 0; the size is a power of two
};

}  // namespace abflat
