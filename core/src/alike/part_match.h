#pragma once

#include <utility>
#include <vector>

#include "alike/part_shapes.h"

namespace abflat {

/// Per corner of a polygon, the one that it corresponds to.
using CornerMatch = IdVector<PolygonCorner, PolygonCorner>;

/// A corner from which a part is walked, and what corners of other parts have to share with it.
struct PartSeed {
  PolygonCorner corner;
  std::uint64_t color = 0;
  double low = 0, high = 0;  ///< distance from the centre
};

/// The corner is one of the fewest that look alike, and far out, so that few have to be tried.
PartSeed seedOf(const Cells& cells, const PartShapes& shapes, PartId part);

/// Finds how one part lies on another.
class PartMatcher {
 public:
  PartMatcher(const Cells& cells, const PartShapes& shapes)
      : cells_(cells), shapes_(shapes), image_(cells.twin.size()), isTaken_(cells.part.size(), 0) {}

  /// Whether moving and turning, or mirroring as well, takes `part` to `model`. Sets the
  /// corresponding corners of the part then. Of several ways it takes the one with the least turn.
  bool match(PartId model, const PartSeed& seed, PartId part, bool isMirrored);

  /// The corners found so far.
  CornerMatch take() { return std::move(image_); }

 private:
  std::vector<PolygonCorner> candidates(PartId model, const PartSeed& seed, PartId part,
                                        bool isMirrored) const;
  bool walk(PolygonCorner from, PolygonCorner to);
  bool pairFaces(PolygonCorner from, PolygonCorner to);
  bool isSameEdge(PolygonCorner from, PolygonCorner to) const;
  bool isCongruent() const;
  Vec3 onPart(PolygonCorner c) const;
  Vec3 onModel(PolygonCorner c) const;
  template <class Value>
  PolygonCorner farthest(const Value& value) const;
  void forget();

  const Cells& cells_;
  const PartShapes& shapes_;
  CornerMatch image_;
  IdVector<PolygonFace, std::uint8_t> isTaken_;  ///< polygons of the model that have been reached
  std::vector<PolygonFace> taken_;               ///< the same as a list
  std::vector<PolygonFace> walked_;              ///< polygons of the part, in order
  PartId model_, part_;
  bool isMirrored_ = false;
  double tolerance_ = 0;
};

}  // namespace abflat
