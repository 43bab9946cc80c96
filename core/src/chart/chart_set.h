#pragma once

#include <cstdint>
#include <vector>

#include "chart/disk_chart.h"
#include "chart/ids.h"
#include "cut/filled_table.h"
#include "mesh/ids.h"

namespace abflat {

/// How a chart is connected; names as in DiskChart.
struct ChartTopology {
  IdSpan<ChartCorner, ChartVertex> vertexOfCorner;
  IdSpan<ChartCorner, ChartCorner> twin;
  IdSpan<BoundaryIndex, ChartCorner> boundary;
  IdSpan<ChartVertex, InputVertex> inputVertex;
  /// Triangles of the surface, without those that fill holes, which come last in the chart.
  IdSpan<ChartTriangle, SurfaceTriangle> triangles;
  std::uint32_t filledHoles = 0;

  std::size_t triangleCount() const { return vertexOfCorner.size() / 3; }
  std::size_t vertexCount() const { return inputVertex.size(); }
  IdRange<ChartCorner> surfaceCorners() const { return IdRange<ChartCorner>(3 * triangles.size()); }
  /// The corner of the surface that corresponds to a corner of one of these triangles.
  SurfaceCorner onSurface(ChartCorner c) const {
    return cornerOf(triangles[triangleOf(c)], placeInTriangle(c));
  }
};

/// The parts of a surface that has been cut into topological disks, in the order of their first
/// triangles. There may be as many charts as triangles, so they share a few arrays, and a chart
/// that can be flattened or checked is made only when it is needed.
class ChartSet {
 public:
  std::size_t size() const { return parts_.empty() ? 0 : parts_.size() - 1; }
  IdRange<ChartId> ids() const { return IdRange<ChartId>(size()); }
  ChartTopology topology(ChartId i) const;
  DiskChart chart(ChartId i) const;
  /// The chart in an order that does not depend on the numbers of the input, as far as elimination
  /// ranks do not. `former`: the number that each vertex has in chart(i).
  DiskChart chartInOrder(ChartId i, IdVector<ChartVertex, ChartVertex>& former) const;
  /// The texcoord of a chart's first vertex; those of its other vertices follow. For the index one
  /// past the last chart it is the total count.
  TexcoordId firstTexcoord(ChartId i) const { return TexcoordId(parts_[i].vertex); }
  TexcoordId texcoord(ChartId i, ChartVertex v) const { return TexcoordId(parts_[i].vertex + v); }

  IdVector<SurfaceTriangle, ChartId> ofTriangle;
  /// How many times as far above 1 as elsewhere a chart's stretch may be; empty: once.
  IdVector<ChartId, double> leeway;
  double leewayOf(ChartId i) const { return leeway.empty() ? 1 : leeway[i]; }
  /// As in DiskChart, per vertex of the mesh; empty if unknown.
  IdVector<InputVertex, std::uint32_t> eliminationRank;

 private:
  friend class ChartSetMaker;
  /// All but what placeChart sets.
  DiskChart unplaced(ChartId i) const;

  /// Where a chart's part of each array begins, which is also where the previous chart's part ends.
  struct Part {
    std::uint32_t triangle = 0, vertex = 0, boundary = 0;
    std::uint32_t fillingTriangles = 0, filledHoles = 0;
  };

  const PolygonMesh* mesh_ = nullptr;
  std::vector<Part> parts_;  ///< one more than there are charts
  std::vector<SurfaceTriangle> triangles_;
  std::vector<ChartVertex> vertexOfCorner_;
  std::vector<ChartCorner> twin_, boundary_;
  std::vector<InputVertex> inputVertex_;
};

/// Precondition: every part is a disk, hole fillings included. The charts' inputVertex refers to
/// vertices of `mesh`, to which the set keeps a reference.
ChartSet makeCharts(const PolygonMesh& mesh, const FilledTable& cut);

}  // namespace abflat
