#pragma once

#include <cstdint>
#include <vector>

#include "chart/disk_chart.h"
#include "hole/filled_table.h"

namespace abflat {

/// The parts of a surface that has been cut into topological disks, in the order of their first
/// triangles.
struct ChartSet {
  std::vector<DiskChart> charts;
  std::vector<std::vector<std::uint32_t>> triangles;  ///< per chart: surface triangle of each
  std::vector<std::uint32_t> ofTriangle;              ///< chart per surface triangle
};

/// Precondition: every part is a disk, what fills holes included. inputVertex of the charts are
/// vertices of `mesh`.
ChartSet makeCharts(const PolygonMesh& mesh, const FilledTable& cut);

}  // namespace abflat
