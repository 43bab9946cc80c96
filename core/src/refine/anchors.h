#pragma once

#include <cstdint>
#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// What keeps a layout from moving as a whole, which changes no energy.
struct Anchors {
  IdVector<ChartVertex, std::uint8_t> isFixed;
  /// If nothing had to be fixed, one vertex is, and the vertex farthest from it is kept from
  /// turning round it.
  ChartVertex centre, arm;
};

/// `isFixed`: which vertices have to stay where they are; empty: none.
Anchors anchorsOf(const DiskChart& chart, const std::vector<double>& uv,
                  const IdVector<ChartVertex, std::uint8_t>& isFixed);

}  // namespace abflat
