#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "abflat/unwrap.h"
#include "unwrap/laid_charts.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// Joins charts to a neighbour that nobody would cut out: those below a thousandth of the surface,
/// or narrower than a few texels. What cannot be joined all around keeps a slit.
class SmallCharts {
 public:
  /// Closes seams. Returns those from before; empty if there is nothing left to try. Unions are
  /// disks, which then have to be laid out.
  Seams join(const LaidCharts& charts, const UnwrapOptions& options, OpenSurface& open);

  /// For each chart of `before`, whether what it is now part of has to be taken back: it is not
  /// valid, stretched beyond the bounds, or no longer exact, or its mirror image is. That is not
  /// tried again.
  IdVector<ChartId, std::uint8_t> refused(const LaidCharts& before, const LaidCharts& now,
                                          const UnwrapOptionValues& options, const Mirror& mirror);

 private:
  /// The first triangles of a small chart and of the neighbour that it is joined to.
  using Pair = std::pair<SurfaceTriangle, SurfaceTriangle>;

  bool isRefused(const Pair& pair) const {
    return std::find(refused_.begin(), refused_.end(), pair) != refused_.end();
  }
  void spread(const Mirror& mirror, const ChartSet& set,
              IdVector<ChartId, std::uint8_t>& isBad) const;

  bool isFirst_ = true;
  std::vector<Pair> joined_;  ///< in this round
  std::vector<Pair> refused_;
};

}  // namespace abflat
