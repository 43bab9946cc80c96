#pragma once

#include <cstdint>
#include <vector>

#include "base/pulse.h"
#include "cut/surface_mesh.h"

namespace abflat {

/// Per half-edge, 1 on both sides of a seam. Boundaries are not marked.
using Seams = std::vector<std::uint8_t>;

/// Half-edges of a boundary loop, in order, the surface on their left; lives as long as its
/// surface.
class BoundaryLoop {
 public:
  BoundaryLoop(const std::uint32_t* begin, const std::uint32_t* end) : begin_(begin), end_(end) {}
  const std::uint32_t* begin() const { return begin_; }
  const std::uint32_t* end() const { return end_; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  std::uint32_t operator[](std::size_t i) const { return begin_[i]; }

 private:
  const std::uint32_t *begin_, *end_;
};

/// The surface opened along its seams.
struct CutSurface {
  struct Chart {
    std::uint32_t firstTriangle = 0, triangles = 0;
    std::uint32_t vertices = 0, edges = 0;
    std::uint32_t loops = 0;      ///< of its boundary
    std::uint32_t firstLoop = 0;  ///< loops of a chart follow each other
    double area = 0;

    std::int64_t euler() const { return static_cast<std::int64_t>(vertices) - edges + triangles; }
    bool isDisk() const { return loops == 1 && euler() == 1; }
  };

  std::vector<std::uint32_t> twin;            ///< kNone on seams, too
  std::vector<std::uint32_t> vertexOfCorner;  ///< vertex of the open surface
  std::vector<std::uint32_t> outgoing;        ///< per vertex: the half-edge from which a
                                              ///< counter-clockwise turn passes all of its corners
  std::vector<std::uint8_t> isBoundary;       ///< per vertex
  std::vector<std::uint32_t> meshVertex;      ///< per vertex, of the closed surface
  std::vector<std::uint32_t> chartOfTriangle;
  std::vector<std::uint32_t> triangleOrder;  ///< chart by chart
  std::vector<std::uint32_t> triangleBegin;  ///< size charts + 1
  std::vector<Chart> charts;
  std::vector<std::uint32_t> loopOrder;  ///< half-edges, loop by loop
  std::vector<std::uint32_t> loopBegin;  ///< size loops + 1

  std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(outgoing.size()); }
  BoundaryLoop loop(std::uint32_t i) const {
    return {loopOrder.data() + loopBegin[i], loopOrder.data() + loopBegin[i + 1]};
  }
  /// Of a disk: its only loop.
  BoundaryLoop outline(std::uint32_t chart) const { return loop(charts[chart].firstLoop); }
  std::uint32_t chartOfVertex(std::uint32_t v) const { return chartOfTriangle[outgoing[v] / 3]; }
};

/// `pulse` beats, and is not asked whether to go on.
CutSurface cutAlong(const SeamMesh& mesh, const Seams& seams, const Pulse& pulse = {});

}  // namespace abflat
