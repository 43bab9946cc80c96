#pragma once

#include <cstdint>
#include <vector>

#include "base/pulse.h"
#include "cut/cut_surface.h"

namespace abflat {

/// Cheapest paths from every vertex of a cut surface to its chart's boundary.
struct PathForest {
  /// Per vertex; kBarredCost or more where every path leads through what is barred, infinite in
  /// charts that paths are not needed in.
  std::vector<double> distance;
  std::vector<std::uint32_t>
      towards;                      ///< half-edge of the edge to the next vertex; kNone at a source
  std::vector<std::uint32_t> next;  ///< that vertex
  std::vector<std::uint32_t> source;  ///< where the path ends

  bool isTreeEdge(const CutSurface& s, std::uint32_t h) const {
    return contains(s.vertexOfCorner[h], h, s.twin[h]) ||
           contains(s.vertexOfCorner[nextCorner(h)], h, s.twin[h]);
  }

 private:
  bool contains(std::uint32_t v, std::uint32_t h, std::uint32_t o) const {
    return towards[v] != kNone && (towards[v] == h || towards[v] == o);
  }
};

/// Sources are all boundary vertices and `extra` ones (one for each closed chart).
/// `pulse` beats, and is not asked whether to go on. `isWanted`: per chart whether paths are needed
/// there; empty: everywhere.
PathForest findPaths(const SeamMesh& mesh, const CutSurface& surface,
                     const std::vector<std::uint32_t>& extra,
                     const std::vector<std::uint8_t>& isWanted = {}, const Pulse& pulse = {});

/// Marks the path from a vertex to its source as seams; returns the length of what was not marked
/// before.
double markPath(const SeamMesh& mesh, const PathForest& forest, std::uint32_t vertex, Seams& seams);
double markEdge(const SeamMesh& mesh, std::uint32_t h, Seams& seams);

}  // namespace abflat
