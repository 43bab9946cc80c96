#pragma once

#include <cmath>
#include <vector>

#include "catch.h"
#include "pack/pack.h"
#include "pack/texels.h"

namespace abflat::test {

inline PackOptions at(const AtlasSize& resolution, int padding) {
  PackOptions options;
  options.resolution = resolution;
  options.padding = padding;
  return options;
}

/// A packing that is there.
inline Packing packed(const std::vector<PackShape>& shapes, const PackOptions& options) {
  const Result<Packing> result = pack(shapes, options);
  INFO(result.status().message);
  REQUIRE(result.ok());
  REQUIRE(result.value().placements.size() == shapes.size());
  return result.value();
}

/// No texel has two charts, and padding and margin are as asked.
inline void checkPacked(const std::vector<PackShape>& shapes, const PackOptions& options) {
  const Packing packing = packed(shapes, options);
  CHECK(complaint(shapes, packing, options) == "");
  CHECK(complaint(shapes, packing, options, true) == "");
  for (const Placement& p : packing.placements)
    CHECK(std::hypot(p.a, p.b) == Approx(packing.scale).epsilon(1e-13));
  CHECK(packing.utilization > 0);
  CHECK(packing.utilization < 1);
}

}  // namespace abflat::test
