#include "io/split_vertices.h"

#include <cstring>

#include "abflat/mesh.h"
#include "io/first_alike.h"

namespace abflat {
namespace {

/// Orders all doubles, including NaNs. Both zeros are equal.
std::int64_t orderOf(double x) {
  std::int64_t bits = 0;
  const double same = x == 0 ? 0 : x;
  std::memcpy(&bits, &same, sizeof bits);
  return bits;
}

}  // namespace

SplitVertices splitVertices(std::size_t vertexCount, const std::vector<std::uint32_t>& faceVertices,
                            const std::vector<double>& uv,
                            const std::vector<std::uint32_t>& cornerUv) {
  SplitVertices out;
  out.ofCorner = faceVertices;
  if (uv.empty()) return out;
  constexpr double kNowhere[2] = {};
  const auto uvOf = [&](std::uint32_t c) {
    return cornerUv[c] == kNoTexcoord ? kNowhere : &uv[2 * std::size_t{cornerUv[c]}];
  };
  // Equal texcoords count as one, whatever their indices.
  const auto isLess = [&](std::uint32_t a, std::uint32_t b) {
    const double *p = uvOf(a), *q = uvOf(b);
    const std::int64_t pu = orderOf(p[0]), qu = orderOf(q[0]);
    return pu != qu ? pu < qu : orderOf(p[1]) < orderOf(q[1]);
  };
  const std::vector<std::uint32_t> first = firstAlike(vertexCount, faceVertices, isLess);
  out.uv.assign(2 * vertexCount, 0);
  std::vector<std::uint8_t> isUsed(vertexCount, 0);
  for (std::uint32_t c = 0; c < first.size(); ++c) {
    std::uint32_t& at = out.ofCorner[c];
    if (first[c] != c) {
      at = out.ofCorner[first[c]];
      continue;
    }
    if (isUsed[at]) {
      out.copied.push_back(at);
      at = static_cast<std::uint32_t>(out.uv.size() / 2);
      out.uv.insert(out.uv.end(), {0, 0});
    } else {
      isUsed[at] = 1;
    }
    for (std::size_t d = 0; d < 2; ++d) out.uv[2 * std::size_t{at} + d] = uvOf(c)[d];
  }
  return out;
}

}  // namespace abflat
