#include "abflat/corner_frames.h"

#include <array>
#include <cmath>

#include "abflat/tangents.h"

namespace abflat {
namespace {

constexpr std::array<std::size_t, 3> kAsIs = {0, 1, 2}, kReversed = {0, 2, 1};

std::array<double, 3> crossProduct(const double* a, const double* b, const double* c) {
  std::array<double, 3> out{};
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
    out[d] = (b[e] - a[e]) * (c[f] - a[f]) - (b[f] - a[f]) * (c[e] - a[e]);
  }
  return out;
}

double lengthOf(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

std::vector<bool> mirroredFaces(const FrameMesh& mesh) {
  std::vector<bool> out(mesh.faces());
  for (const FramePart& part : mesh.parts)
    for (std::size_t f = part.firstFace; f < std::size_t{part.firstFace} + part.faceCount; ++f)
      out[f] = part.isMirrored;
  return out;
}

std::vector<float> mikk(const FrameMesh& mesh, const std::vector<double>& uv,
                        const std::vector<float>& normals, const std::vector<bool>& isReversed) {
  std::vector<float> out(4 * mesh.corners.size());
  for (const FramePart& part : mesh.parts) {
    TangentInput input;
    const std::size_t last = std::size_t{part.firstFace} + part.faceCount;
    for (std::size_t f = part.firstFace; f < last; ++f)
      for (const std::size_t k : isReversed[f] ? kReversed : kAsIs) {
        const std::size_t c = 3 * f + k, v = mesh.vertex(f, k);
        input.positions.insert(input.positions.end(), &mesh.positions[3 * v],
                               &mesh.positions[3 * v] + 3);
        input.normals.insert(input.normals.end(), &normals[3 * c], &normals[3 * c] + 3);
        input.uv.insert(input.uv.end(), &uv[2 * c], &uv[2 * c] + 2);
      }
    const std::vector<float> tangents = mikkTangents(input);
    const float* next = tangents.data();
    for (std::size_t f = part.firstFace; f < last; ++f)
      for (const std::size_t k : isReversed[f] ? kReversed : kAsIs)
        for (std::size_t d = 0; d < 4; ++d) out[4 * (3 * f + k) + d] = *next++;
  }
  return out;
}

}  // namespace

std::uint32_t FrameMesh::vertex(std::size_t face, std::size_t corner) const {
  return corners[3 * face + (isTurned[face] ? kReversed : kAsIs)[corner]];
}

std::vector<float> cornerNormals(const FrameMesh& mesh) {
  std::vector<float> out;
  out.reserve(3 * mesh.corners.size());
  const std::vector<bool> isMirrored = mirroredFaces(mesh);
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const std::array<const double*, 3> p = {&mesh.positions[3 * std::size_t{mesh.vertex(f, 0)}],
                                            &mesh.positions[3 * std::size_t{mesh.vertex(f, 1)}],
                                            &mesh.positions[3 * std::size_t{mesh.vertex(f, 2)}]};
    const std::array<double, 3> flat =
        isMirrored[f] ? crossProduct(p[0], p[2], p[1]) : crossProduct(p[0], p[1], p[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const float* const given = &mesh.normals[3 * std::size_t{mesh.vertex(f, k)}];
      std::array<double, 3> n = {given[0], given[1], given[2]};
      if (!(lengthOf(n) > 0)) n = flat;
      const double length = lengthOf(n);
      for (const double x : n) out.push_back(static_cast<float>(length > 0 ? x / length : x));
    }
  }
  return out;
}

std::vector<float> oldTangents(const FrameMesh& mesh, const std::vector<double>& oldUv,
                               const std::vector<float>& normals) {
  std::vector<bool> isReversed = mirroredFaces(mesh);
  for (std::size_t f = 0; f < mesh.faces(); ++f) isReversed[f] = isReversed[f] != mesh.isTurned[f];
  std::vector<float> out = mikk(mesh, oldUv, normals, isReversed);
  for (const FramePart& part : mesh.parts) {
    if (!part.hasTangents) continue;
    for (std::size_t f = part.firstFace; f < std::size_t{part.firstFace} + part.faceCount; ++f)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t d = 0; d < 4; ++d)
          out[4 * (3 * f + k) + d] = mesh.tangents[4 * std::size_t{mesh.vertex(f, k)} + d];
  }
  return out;
}

std::vector<float> newTangents(const FrameMesh& mesh, const std::vector<double>& uv,
                               const std::vector<float>& normals) {
  return mikk(mesh, uv, normals, mirroredFaces(mesh));
}

}  // namespace abflat
