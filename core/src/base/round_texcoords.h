#pragma once

#include <cmath>
#include <vector>

namespace abflat {

/// Rounds to single precision.
inline double toSingle(double x) { return static_cast<double>(static_cast<float>(x)); }

inline void roundToSingle(std::vector<double>& uv) {
  for (double& x : uv) x = toSingle(x);
}

/// As roundToSingle, but 1 - v is in single precision, which is what a glTF stores. Exact: writing
/// 1 - v again gives the same float.
inline void roundForGltf(std::vector<double>& uv) {
  for (std::size_t i = 0; i < uv.size(); ++i)
    uv[i] = i % 2 == 0 ? toSingle(uv[i]) : 1 - toSingle(1 - uv[i]);
}

/// Rounds to multiples of 2^-24: up to 1, both x and 1 - x are then exact in single precision.
inline void roundInAtlas(std::vector<double>& uv) {
  for (double& x : uv) x = toSingle(std::floor(x * 0x1p24 + 0.5) * 0x1p-24);
}

}  // namespace abflat
