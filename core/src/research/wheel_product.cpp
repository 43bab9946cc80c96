#include "research/wheel_product.h"

#include <cmath>

#include "base/portable_math.h"

namespace abflat {

WheelProducts wheelProducts(const AngleProblem& problem, const std::vector<double>& angles) {
  WheelProducts out(problem.vertexCount());
  for (const ChartCorner c : problem.corners()) {
    WheelProduct& wheel = out[problem.vertexOfCorner[c]];
    wheel.next *= portable::sin(angles[nextCorner(c)]);
    wheel.prev *= portable::sin(angles[prevCorner(c)]);
  }
  return out;
}

VertexCorners cornersOfVertices(const AngleProblem& problem) {
  VertexCorners out;
  out.offset.assign(problem.vertexCount() + 1, 0);
  for (const ChartVertex v : problem.vertexOfCorner) ++out.offset[v + 1];
  for (const ChartVertex v : problem.vertices()) out.offset[v + 1] += out.offset[v];
  std::vector<std::uint32_t> fill = out.offset;
  out.corner.resize(problem.vertexOfCorner.size());
  for (const ChartCorner c : problem.corners()) out.corner[fill[problem.vertexOfCorner[c]]++] = c;
  return out;
}

}  // namespace abflat
