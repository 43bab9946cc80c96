#pragma once

#include <string_view>
#include <vector>

#include "abflat/mesh.h"

namespace abflat {

/// Generated disks to try things on. `detail` >= 1 scales the resolution: faces grow about linearly
/// with it.
struct Sample {
  std::string_view name;   ///< "hemisphere", "wavy-strip", "head", "alpha-band"
  std::string_view title;  ///< for people
  PolygonMesh (*make)(double detail);
};

const std::vector<Sample>& samples();

}  // namespace abflat
