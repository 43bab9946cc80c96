#pragma once

#include <utility>

#include "abflat/unwrap.h"
#include "catch.h"

namespace abflat::test {

/// Options that give several charts for small meshes.
inline UnwrapOptions severalCharts() {
  UnwrapOptions out;
  out.resolution = 256;
  out.maxStretch = 1.001;
  return out;
}

/// Unwraps and checks that the atlas is valid.
inline UnwrapResult unwrapped(const PolygonMesh& mesh, const UnwrapOptions& options) {
  Result<UnwrapResult> result = unwrap(mesh, options);
  INFO(result.status().message);
  REQUIRE(result.ok());
  CHECK(result.value().report.valid);
  return std::move(result.value());
}

}  // namespace abflat::test
