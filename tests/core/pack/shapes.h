#pragma once

#include <string>
#include <vector>

#include "pack/pack.h"

namespace abflat::test {

/// Charts for testing packing: "discs", "blobs", "stars", "spirals", "letters" (L, U and C),
/// "needles", "triangles", "rectangles" or "mixed" (all of them). Sizes vary by a factor of
/// `spread`.
std::vector<PackShape> makePackShapes(const std::string& kind, std::size_t count, double spread,
                                      unsigned seed);

}  // namespace abflat::test
