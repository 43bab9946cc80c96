#pragma once

#include "alike/part_match.h"

namespace abflat {

/// Finds parts that are alike: moving and turning takes one to the other, or mirroring as well if
/// `mayMirror`, with no vertex off by more than kAlikeTolerance. Per corner, the corresponding one
/// of the part's model, which is the corner itself in models and in parts like no other. None where
/// there is no part. Does not depend on numbers.
CornerMatch findAlike(const Cells& cells, const IdVector<PartId, std::uint8_t>& isLeftOut,
                      bool mayMirror);

/// Whether the polygon of a corner is the mirror image of its model's.
bool isMirroredAt(const Cells& cells, const CornerMatch& match, PolygonCorner c);

}  // namespace abflat
