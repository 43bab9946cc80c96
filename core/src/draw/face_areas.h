#pragma once

#include <vector>

#include "abflat/unwrap.h"

namespace abflat {

/// Areas per face of the mesh, and their sums; those of a face that is not plane are of its area
/// vector.
struct FaceAreas {
  std::vector<double> in3d, inUv;
  double sum = 0, uvSum = 0;
};
FaceAreas faceAreas(const PolygonMesh& mesh, const UnwrapResult& result);

}  // namespace abflat
