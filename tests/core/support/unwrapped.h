#pragma once

#include <utility>

#include "abflat/unwrap.h"
#include "catch.h"

namespace abflat::test {

/// So that there are several charts of small meshes.
inline UnwrapOptions severalCharts() {
  UnwrapOptions out;
  out.resolution = 256;
  out.maxStretch = 1.002;
  return out;
}

/// A valid atlas.
inline UnwrapResult unwrapped(const PolygonMesh& mesh, const UnwrapOptions& options) {
  Result<UnwrapResult> result = unwrap(mesh, options);
  INFO(result.status.message);
  REQUIRE(result.ok());
  CHECK(result.value.report.valid);
  return std::move(result.value);
}

}  // namespace abflat::test
