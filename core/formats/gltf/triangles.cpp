#include "gltf/triangles.h"

namespace abflat::gltf {

bool hasTriangles(Mode mode) {
  return mode == Mode::Triangles || mode == Mode::TriangleStrip || mode == Mode::TriangleFan;
}

std::vector<std::uint32_t> asTriangles(Mode mode, std::vector<std::uint32_t> vertices) {
  if (mode == Mode::Triangles) {
    vertices.resize(vertices.size() / 3 * 3);
    return vertices;
  }
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i + 2 < vertices.size(); ++i) {
    const std::size_t odd = i % 2;  // every other triangle of a strip has the opposite orientation
    if (mode == Mode::TriangleStrip)
      out.insert(out.end(), {vertices[i], vertices[i + 1 + odd], vertices[i + 2 - odd]});
    else
      out.insert(out.end(), {vertices[i + 1], vertices[i + 2], vertices[0]});
  }
  return out;
}

}  // namespace abflat::gltf
