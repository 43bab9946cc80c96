#pragma once

namespace abflat::fuzz {

/// Sign of the area of the triangle a, b, c (2 coordinates each): 1 where it is counter-clockwise,
/// -1 where it is clockwise, 0 where it has none. Exact for all finite numbers, and independent of
/// the predicates of the core: six products are added up in a fixed-point number that is wide
/// enough for any of them.
int exactTurn(const double* a, const double* b, const double* c);

}  // namespace abflat::fuzz
