#pragma once

#include <vector>

#include "abflat/unwrap.h"

namespace abflat {

/// Areas per face of the mesh, and their sums; for a face that is not planar, the length of its
/// area vector counts.
struct FaceAreas {
  std::vector<double> in3d, inUv;
  double sum = 0, uvSum = 0;
};
FaceAreas faceAreas(const PolygonMesh& mesh, const UnwrapResult& result);

}  // namespace abflat
