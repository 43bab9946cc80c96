#include "gltf/split_parts.h"

#include <algorithm>
#include <utility>

#include "io/split_vertices.h"

namespace abflat::gltf {
namespace {

void addTexcoord(const SplitVertices& split, std::size_t vertex, std::vector<float>& out) {
  out.push_back(static_cast<float>(split.uv[2 * vertex]));
  out.push_back(static_cast<float>(1 - split.uv[2 * vertex + 1]));
}

/// The group that a vertex of the mesh belongs to.
std::size_t groupOf(const std::vector<VertexGroup>& groups, std::uint32_t vertex) {
  // The last group that begins there or earlier: groups without vertices come before it.
  const auto next = std::upper_bound(
      groups.begin(), groups.end(), vertex,
      [](std::uint32_t v, const VertexGroup& group) { return v < group.firstVertex; });
  return static_cast<std::size_t>(next - groups.begin()) - 1;
}

}  // namespace

SplitParts splitParts(const Source& source, const std::vector<double>& uv,
                      const std::vector<std::uint32_t>& cornerUv,
                      const std::vector<std::uint32_t>& turnedFaces) {
  std::vector<std::uint32_t> faceVertices = source.faceVertices;
  for (const std::uint32_t f : turnedFaces)
    std::swap(faceVertices[3 * std::size_t{f} + 1], faceVertices[3 * std::size_t{f} + 2]);
  SplitVertices split = splitVertices(source.vertexCount, faceVertices, uv, cornerUv);
  // A mesh without faces has no texcoords.
  if (split.uv.empty()) split.uv.assign(2 * std::size_t{source.vertexCount}, 0);
  SplitParts out;
  for (const VertexGroup& group : source.groups) {
    out.groups.emplace_back();
    for (std::uint32_t v = 0; v < group.vertexCount; ++v)
      addTexcoord(split, group.firstVertex + v, out.groups.back().uv);
  }
  const std::uint32_t vertices = source.vertexCount;
  std::vector<std::uint32_t> local;  // index of each copy in its group
  for (std::size_t i = 0; i < split.copied.size(); ++i) {
    const std::size_t g = groupOf(source.groups, split.copied[i]);
    SplitGroup& group = out.groups[g];
    local.push_back(static_cast<std::uint32_t>(group.uv.size() / 2));
    group.copied.push_back(split.copied[i] - source.groups[g].firstVertex);
    addTexcoord(split, vertices + i, group.uv);
  }
  for (const Part& part : source.parts) {
    SplitPart& now = out.parts.emplace_back();
    const std::uint32_t first = source.groups[part.group].firstVertex;
    const std::size_t second = part.isMirrored ? 2 : 1;
    for (std::size_t f = part.firstFace; f < part.firstFace + std::size_t{part.faceCount}; ++f)
      for (const std::size_t k : {std::size_t{0}, second, 3 - second}) {
        const std::uint32_t v = split.ofCorner[3 * f + k];
        now.needsIndices = now.needsIndices || v >= vertices;
        now.triangles.push_back(v < vertices ? v - first : local[v - vertices]);
      }
    const bool isIndexed = source.document.meshes[part.mesh][part.primitive].indices != kNone;
    const auto turned = std::lower_bound(turnedFaces.begin(), turnedFaces.end(), part.firstFace);
    if (turned != turnedFaces.end() && *turned < part.firstFace + std::uint64_t{part.faceCount})
      now.needsIndices = true;
    // Without indices all vertices are drawn, including copies.
    if (!isIndexed && !out.groups[part.group].copied.empty()) now.needsIndices = true;
  }
  return out;
}

}  // namespace abflat::gltf
