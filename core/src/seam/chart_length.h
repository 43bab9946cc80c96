#pragma once

#include <vector>

#include "cut/cut_surface.h"
#include "pack/outline.h"

namespace abflat {

/// A place where a chart can be cut across: a vertex on either side of it.
struct AcrossPlace {
  OpenVertex before, after;  ///< the outline goes from `before` around the first end to `after`
};

/// A flattened chart seen as a strip from one end to the other, which may bend.
class ChartLength {
 public:
  ChartLength() = default;
  /// `at`: positions of the surface's vertices in the plane. `isPreferred`: vertices at which the
  /// chart is cut if one is near, such as those on creases; may be empty.
  ChartLength(const CutSurface& surface, const IdVector<OpenVertex, PlanePoint>& at,
              CutChartId chart, const IdVector<OpenVertex, std::uint8_t>& isPreferred = {});

  double length() const { return length_; }
  /// Whether there are preferred vertices away from the ends.
  bool hasPreferred() const;

  /// The places that divide the length into `parts` about equal parts, as well as the outline's
  /// vertices allow, from the first end on. Fewer if there are not enough vertices.
  std::vector<AcrossPlace> places(int parts) const;

 private:
  struct Stop {
    OpenVertex vertex;
    PlanePoint at;
    double reached = 0;  ///< largest distance from the first end so far
    bool isPreferred = false;
  };
  using Side = std::vector<Stop>;
  std::size_t stopNear(double reached, double reach) const;
  std::size_t opposite(const Stop& stop, double reach) const;

  double length_ = 0;
  Side before_, after_;  ///< from the first end to the other, against and along the outline
};

}  // namespace abflat
