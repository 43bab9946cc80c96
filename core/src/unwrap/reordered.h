#pragma once

#include <vector>

#include "base/point2.h"
#include "mesh/ids.h"

namespace abflat {

/// Coordinates in the order of ChartSet::chartInOrder(), from that of chart(). `former`: the number
/// there of each vertex.
inline std::vector<double> inOrder(const std::vector<double>& uv,
                                   const IdVector<ChartVertex, ChartVertex>& former) {
  std::vector<double> out(uv.size());
  for (const ChartVertex v : former.ids()) setPoint(out, v, pointAt(uv, former[v]));
  return out;
}

/// The reverse.
inline std::vector<double> inFormerOrder(const std::vector<double>& uv,
                                         const IdVector<ChartVertex, ChartVertex>& former) {
  std::vector<double> out(uv.size());
  for (const ChartVertex v : former.ids()) setPoint(out, former[v], pointAt(uv, v));
  return out;
}

}  // namespace abflat
