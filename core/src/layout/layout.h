#pragma once

#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// Positions of the flat mesh from its angles, up to rounding of the angles' own residual.
///
/// Logarithms of edge lengths and headings of edges are carried over a spanning tree of triangles:
/// both are sums, so errors add up instead of multiplying. Vertices are then placed along the
/// minimum spanning tree of the edges by length, which bounds the error between two neighbours by
/// the edges near them. O(n log n).
///
/// Returns uv, 2 per chart vertex, positively oriented, of the chart's 3D area (in chart units),
/// the longest diameter horizontal and the lower left corner of the bounding box at the origin.
std::vector<double> layOut(const DiskChart& chart, const std::vector<double>& angles);

}  // namespace abflat
