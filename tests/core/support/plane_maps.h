#pragma once

#include <random>
#include <vector>

#include "refine/plane_map.h"

namespace abflat::test {

/// Random orientation-preserving maps, from nearly conformal to nearly singular.
inline std::vector<PlaneMap> someMaps() {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<PlaneMap> out{{1, 0, 0, 0}, {0, -3, 0, 0}, {0.6, 0.8, 0, 0}};
  while (out.size() < 200) {
    PlaneMap m;
    for (double& x : m) x = normal(random);
    if (determinant(m) > 0.05) out.push_back(m);
  }
  return out;
}

}  // namespace abflat::test
