#include "research/wheel_product.h"

#include <cmath>

#include "base/portable_math.h"

namespace abflat {

std::vector<WheelProduct> wheelProducts(const AngleProblem& problem,
                                        const std::vector<double>& angles) {
  std::vector<WheelProduct> out(problem.vertexCount());
  for (std::uint32_t f = 0; f < problem.triangleCount(); ++f)
    for (std::uint32_t k = 0; k < 3; ++k) {
      WheelProduct& wheel = out[problem.vertexOfCorner[3 * f + k]];
      wheel.next *= portable::sin(angles[3 * f + (k + 1) % 3]);
      wheel.prev *= portable::sin(angles[3 * f + (k + 2) % 3]);
    }
  return out;
}

VertexCorners cornersOfVertices(const AngleProblem& problem) {
  VertexCorners out;
  out.offset.assign(problem.vertexCount() + 1, 0);
  for (std::uint32_t v : problem.vertexOfCorner) ++out.offset[v + 1];
  for (std::uint32_t v = 0; v < problem.vertexCount(); ++v) out.offset[v + 1] += out.offset[v];
  std::vector<std::uint32_t> fill = out.offset;
  out.corner.resize(problem.vertexOfCorner.size());
  for (std::uint32_t c = 0; c < out.corner.size(); ++c)
    out.corner[fill[problem.vertexOfCorner[c]]++] = c;
  return out;
}

}  // namespace abflat
