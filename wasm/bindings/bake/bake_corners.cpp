#include "bake/bake_corners.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "abflat/corner_frames.h"

namespace abflat::bindings {
namespace {

constexpr std::array<std::size_t, 3> kAsIs = {0, 1, 2}, kReversed = {0, 2, 1};

Status invalid(std::string text) { return {StatusCode::InvalidMesh, std::move(text)}; }

std::string triangleAt(std::size_t corner) { return "triangle " + std::to_string(corner / 3); }

/// Vertex of the mesh at a corner of the layout.
std::uint32_t vertexAt(const BakeJob& job, std::size_t corner) {
  const std::uint32_t vertex = job.layoutIndices[corner];
  return job.vertexMap.empty() ? vertex : job.vertexMap[vertex];
}

Status checkNumbers(const std::vector<std::uint32_t>& numbers, std::size_t count,
                    const std::string& of) {
  for (std::size_t c = 0; c < numbers.size(); ++c)
    if (numbers[c] >= count)
      return invalid(triangleAt(c) + " " + of + " vertex " + std::to_string(numbers[c]) +
                     ", but there are only " + std::to_string(count) + " vertices");
  return {};
}

/// `mayLack`: NaN stands for none.
template <class T>
Status checkFinite(const std::vector<T>& numbers, std::size_t size, const std::string& what,
                   bool mayLack = false) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!std::isfinite(numbers[i]) && !(mayLack && std::isnan(numbers[i])))
      return invalid("vertex " + std::to_string(i / size) + " has a " + what +
                     " that is not finite");
  return {};
}

bool isSame(const BakeJob& job, std::size_t face, const std::array<std::size_t, 3>& order) {
  for (std::size_t k = 0; k < 3; ++k)
    if (vertexAt(job, 3 * face + k) != job.indices[3 * face + order[k]]) return false;
  return true;
}

/// Runs of triangles with the same number.
std::vector<FramePart> partsOf(const BakeJob& job) {
  const auto faces = static_cast<std::uint32_t>(job.indices.size() / 3);
  std::vector<FramePart> out;
  for (std::uint32_t f = 0; f < faces; ++f) {
    const bool isNew = f == 0 || (!job.parts.empty() && job.parts[f] != job.parts[f - 1]);
    const bool hasTangents =
        !job.tangents.empty() && job.tangents[4 * std::size_t{job.indices[3 * f]} + 3] != 0;
    if (isNew) out.push_back({f, 0, false, hasTangents});
    ++out.back().faceCount;
  }
  return out;
}

}  // namespace

Status matchCorners(const BakeJob& job, std::vector<bool>& isTurned) {
  const std::size_t vertices = job.texcoords.size() / 2;
  if (Status s = checkNumbers(job.indices, vertices, "of the mesh refers to"); !s.ok()) return s;
  if (Status s = checkNumbers(job.layoutIndices, job.uv.size() / 2, "of the layout refers to");
      !s.ok())
    return s;
  isTurned.assign(job.indices.size() / 3, false);
  for (std::size_t f = 0; f < isTurned.size(); ++f) {
    if (isSame(job, f, kAsIs)) continue;
    if (!isSame(job, f, kReversed))
      return invalid(triangleAt(3 * f) +
                     " of the layout has other vertices than that of the mesh: pass the mesh that "
                     "the layout was made of");
    isTurned[f] = true;
  }
  return {};
}

BakeTriangles trianglesOf(const BakeJob& job) {
  BakeTriangles out;
  const std::size_t corners = job.layoutIndices.size();
  const auto add = [](std::vector<double>& list, const std::vector<double>& from,
                      std::uint32_t vertex) {
    const double u = from[2 * std::size_t{vertex}], v = from[2 * std::size_t{vertex} + 1];
    const bool isMapped = !std::isnan(u) && !std::isnan(v);
    list.push_back(isMapped ? u : 0);
    list.push_back(isMapped ? 1 - v : 0);
  };
  out.uv.reserve(2 * corners);
  out.oldUv.reserve(2 * corners);
  for (std::size_t c = 0; c < corners; ++c) {
    add(out.uv, job.uv, job.layoutIndices[c]);
    add(out.oldUv, job.texcoords, vertexAt(job, c));
  }
  if (!job.colours.empty() && job.kind != ImageKind::Normal)
    for (std::size_t c = 0; c < corners; ++c) {
      const float* const colour = &job.colours[4 * std::size_t{vertexAt(job, c)}];
      out.colours.insert(out.colours.end(), colour, colour + 4);
    }
  out.materials = job.faceMaterials;
  out.materials.resize(corners / 3);
  return out;
}

Status addFrames(const BakeJob& job, const std::vector<bool>& isTurned, BakeTriangles& out) {
  for (const Status& s :
       {checkFinite(job.positions, 3, "position"), checkFinite(job.normals, 3, "normal"),
        checkFinite(job.tangents, 4, "tangent"), checkFinite(job.texcoords, 2, "texcoord", true),
        checkFinite(job.uv, 2, "uv", true)})
    if (!s.ok()) return s;
  std::vector<float> normals = job.normals;
  normals.resize(job.positions.size());
  const FrameMesh mesh{job.indices, isTurned, job.positions, normals, job.tangents, partsOf(job)};
  out.normals = cornerNormals(mesh);
  out.oldTangents = oldTangents(mesh, out.oldUv, out.normals);
  out.tangents = newTangents(mesh, out.uv, out.normals);
  return {};
}

}  // namespace abflat::bindings
