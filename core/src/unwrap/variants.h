#pragma once

#include <vector>

#include "unwrap/flat_cut.h"
#include "unwrap/seam_variant.h"

namespace abflat {

/// What seams, charts and their stretch cost in all.
double costOf(const UnwrapOptionValues& options, FlatCut& cut);

/// Further searches for the seams of a surface that are worth their time, which grows with the
/// number of its triangles. `inFront`: share of it, see shareInFront; `hasMask`: see below.
std::vector<SeamVariant> variantsWorth(std::size_t triangles, double inFront, bool hasMask = false);

/// Whether a component could lie flat without a seam and is mostly the front of a figure.
bool hasMask(const OpenSurface& open);

/// Whether a search for charts that unroll is worth it: all components do already, or one that is
/// built of blocks does not.
bool isExactWorth(const UnwrapOptionValues& options, const FlatCut& cut);

/// Whether no search with other costs would be listened to, since all components nearly unroll.
bool isSettled(const UnwrapOptionValues& options, const FlatCut& cut);

/// Whether people look at some of the surface's seams, as at those across a face.
bool isCutInFront(const OpenSurface& open);

/// Whether takeBetter would replace nothing by `other`, which may still be cut further: its present
/// seams alone cost too much.
bool isHopeless(const UnwrapOptionValues& options, FlatCut& best, FlatCut& other);

/// Replaces seams of components by those of `other` where they and the stretch of their charts cost
/// less; where a component nearly unrolls, only if it still does and they are clearly shorter, too.
/// Layouts of charts move along. Symmetric seams are replaced as a whole, or not at all. False if
/// nothing is replaced.
bool takeBetter(const WeldedMesh& welded, const UnwrapOptionValues& options, FlatCut& best,
                FlatCut& other);

}  // namespace abflat
