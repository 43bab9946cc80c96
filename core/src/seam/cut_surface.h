#pragma once

#include <cstdint>
#include <vector>

#include "pulse.h"
#include "seam/surface_mesh.h"

namespace abflat {

/// Per half-edge, 1 on both sides of a seam. Boundaries are not marked.
using Seams = std::vector<std::uint8_t>;

/// The surface opened along its seams.
struct CutSurface {
  struct Chart {
    std::uint32_t firstTriangle = 0, triangles = 0;
    std::uint32_t vertices = 0, edges = 0;
    std::uint32_t loops = 0;      ///< of its boundary
    std::uint32_t loopBegin = 0;  ///< of the first: loops of a chart follow each other
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
  std::vector<std::vector<std::uint32_t>> loops;  ///< half-edges, the surface on their left

  std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(outgoing.size()); }
  std::uint32_t chartOfVertex(std::uint32_t v) const { return chartOfTriangle[outgoing[v] / 3]; }
};

/// `pulse` beats, and is not asked whether to go on.
CutSurface cutAlong(const SeamMesh& mesh, const Seams& seams, const Pulse& pulse = {});

}  // namespace abflat
