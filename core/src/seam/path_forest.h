#pragma once

#include <cstdint>
#include <vector>

#include "base/listener.h"
#include "cut/cut_surface.h"

namespace abflat {

/// Cheapest paths from every vertex of a cut surface to its chart's boundary.
struct PathForest {
  /// kBarredCost or more if every path passes through a barred edge; infinite in charts for which
  /// no paths are needed.
  IdVector<OpenVertex, double> distance;
  IdVector<OpenVertex, SurfaceCorner> towards;  ///< the edge to the next vertex; none at a source
  IdVector<OpenVertex, OpenVertex> next;
  IdVector<OpenVertex, OpenVertex> source;  ///< where the path ends

  bool isTreeEdge(const CutSurface& s, SurfaceCorner h) const {
    return contains(s.tail(h), h, s.twin[h]) || contains(s.head(h), h, s.twin[h]);
  }

 private:
  bool contains(OpenVertex v, SurfaceCorner h, SurfaceCorner o) const {
    return towards[v].exists() && (towards[v] == h || towards[v] == o);
  }
};

/// Sources are all boundary vertices and the `extra` ones (one for each closed chart). `listener`
/// only beats here; it cannot stop the work. `isWanted`: whether a chart needs paths; empty: all
/// do.
PathForest findPaths(const SeamMesh& mesh, const CutSurface& surface,
                     const std::vector<OpenVertex>& extra,
                     const IdVector<CutChartId, std::uint8_t>& isWanted = {},
                     const Listener& listener = {});

/// A cut mesh, with paths to where it is open.
struct CutPaths {
  const SeamMesh& mesh;
  const CutSurface& surface;
  const PathForest& forest;

  /// Cost of the cheapest way from boundary to boundary along the given edge.
  double costThrough(SurfaceCorner h) const {
    return forest.distance[surface.tail(h)] + mesh.cost[h] + forest.distance[surface.head(h)];
  }
};

/// Marks the path from a vertex to its source as seams; returns the length of the edges that were
/// not marked before.
double markPath(const SeamMesh& mesh, const PathForest& forest, OpenVertex vertex, Seams& seams);
double markEdge(const SeamMesh& mesh, SurfaceCorner h, Seams& seams);
/// Marks an edge and the paths from both of its ends.
void markThrough(const CutPaths& paths, SurfaceCorner h, Seams& seams);

}  // namespace abflat
