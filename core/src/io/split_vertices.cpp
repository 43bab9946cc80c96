#include "io/split_vertices.h"

namespace abflat {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

}  // namespace

SplitVertices splitVertices(std::size_t vertexCount, const std::vector<std::uint32_t>& faceVertices,
                            const std::vector<double>& uv,
                            const std::vector<std::uint32_t>& cornerUv) {
  SplitVertices out;
  out.ofCorner = faceVertices;
  if (uv.empty()) return out;
  out.uv.assign(2 * vertexCount, 0);
  std::vector<std::uint32_t> texcoord(vertexCount, kNone);
  std::vector<std::uint32_t> next(vertexCount, kNone);  // copy of the same vertex
  for (std::size_t c = 0; c < out.ofCorner.size(); ++c) {
    const std::uint32_t wanted = cornerUv[c];
    const double u = uv[2 * wanted], v = uv[2 * wanted + 1];
    std::uint32_t at = out.ofCorner[c];
    // Texcoords that are equal are one, whatever their numbers.
    while (texcoord[at] != kNone && (out.uv[2 * at] != u || out.uv[2 * at + 1] != v)) {
      if (next[at] == kNone) {
        next[at] = static_cast<std::uint32_t>(next.size());
        next.push_back(kNone);
        texcoord.push_back(kNone);
        out.copied.push_back(faceVertices[c]);
        out.uv.insert(out.uv.end(), {0, 0});
      }
      at = next[at];
    }
    texcoord[at] = wanted;
    out.uv[2 * at] = u;
    out.uv[2 * at + 1] = v;
    out.ofCorner[c] = at;
  }
  return out;
}

}  // namespace abflat
