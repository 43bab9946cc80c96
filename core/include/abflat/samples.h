#pragma once

#include <string_view>
#include <vector>

#include "abflat/export.h"
#include "abflat/mesh.h"

namespace abflat {

/// Generated disks to try things on: smooth, consistently oriented, without degenerate faces.
struct Sample {
  std::string_view name;   ///< "hemisphere", "wavy-strip", "head", "alpha-band", "three-balls"
  std::string_view title;  ///< display name
  /// `detail` in [kMinSampleDetail, kMaxSampleDetail] scales the resolution: the number of faces
  /// grows about linearly with it.
  PolygonMesh (*make)(double detail);
};

constexpr double kMinSampleDetail = 1;
constexpr double kMaxSampleDetail = 1000;

ABFLAT_API const std::vector<Sample>& samples();

}  // namespace abflat
