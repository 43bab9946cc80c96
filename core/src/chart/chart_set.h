#pragma once

#include <cstdint>
#include <vector>

#include "chart/disk_chart.h"
#include "cut/filled_table.h"

namespace abflat {

/// Numbers that follow each other in a larger array.
struct Indices {
  const std::uint32_t* first = nullptr;
  std::size_t count = 0;

  const std::uint32_t* begin() const { return first; }
  const std::uint32_t* end() const { return first + count; }
  std::size_t size() const { return count; }
  bool empty() const { return count == 0; }
  std::uint32_t operator[](std::size_t i) const { return first[i]; }
  std::uint32_t front() const { return *first; }
  std::uint32_t back() const { return first[count - 1]; }
};

/// How a chart is connected; names as in DiskChart.
struct ChartTopology {
  Indices vertexOfCorner, twin, boundary, inputVertex;
  std::uint32_t fillingTriangles = 0, filledHoles = 0;

  std::uint32_t triangleCount() const {
    return static_cast<std::uint32_t>(vertexOfCorner.size() / 3);
  }
  std::uint32_t surfaceTriangles() const { return triangleCount() - fillingTriangles; }
  std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(inputVertex.size()); }
};

/// The parts of a surface that has been cut into topological disks, in the order of their first
/// triangles. There may be as many as triangles, so they share a few arrays, and a chart that can
/// be flattened or checked is made when it is needed.
class ChartSet {
 public:
  std::size_t size() const { return parts_.empty() ? 0 : parts_.size() - 1; }
  ChartTopology topology(std::size_t i) const;
  /// Surface triangle of each.
  Indices triangles(std::size_t i) const;
  DiskChart chart(std::size_t i) const;

  std::vector<std::uint32_t> ofTriangle;  ///< chart per surface triangle
  /// Per vertex of the mesh, as in DiskChart; empty where none is known.
  std::vector<std::uint32_t> place;

 private:
  friend class ChartSetMaker;
  /// Where a chart's share of each array begins, which is where that of the one before ends.
  struct Part {
    std::uint32_t triangle = 0, vertex = 0, boundary = 0;
    std::uint32_t fillingTriangles = 0, filledHoles = 0;
  };

  const PolygonMesh* mesh_ = nullptr;
  std::vector<Part> parts_;  ///< one more than charts
  std::vector<std::uint32_t> triangles_, vertexOfCorner_, twin_, boundary_, inputVertex_;
};

/// Precondition: every part is a disk, what fills holes included. inputVertex of the charts are
/// vertices of `mesh`, which the set refers to.
ChartSet makeCharts(const PolygonMesh& mesh, const FilledTable& cut);

}  // namespace abflat
