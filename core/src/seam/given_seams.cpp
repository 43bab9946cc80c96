#include "seam/given_seams.h"

#include <algorithm>

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

std::uint32_t inputCorner(const WeldedMesh& welded, const Surface& surface, std::uint32_t corner) {
  return welded.inputCorner[surface.triangulation.corner[corner]];
}

std::uint32_t inputVertex(const PolygonMesh& input, const WeldedMesh& welded,
                          const Surface& surface, std::uint32_t corner) {
  return input.faceVertices[inputCorner(welded, surface, corner)];
}

EdgeVertices sorted(EdgeVertices e) {
  if (e[0] > e[1]) std::swap(e[0], e[1]);
  return e;
}

Vec3 normalOf(const PolygonMesh& mesh, const Surface& surface, std::uint32_t triangle) {
  const std::uint32_t* v = &surface.table.vertex[3 * static_cast<std::size_t>(triangle)];
  Vec3 n = cross(edgeVector(mesh.positions, v[0], v[1]), edgeVector(mesh.positions, v[0], v[2]));
  const double length = norm(n);
  for (double& x : n) x = length > 0 ? x / length : 0;
  return n;
}

/// Angle between the normals, in degrees; 0 where a triangle has none.
double bend(const Vec3& a, const Vec3& b) {
  return portable::atan2(norm(cross(a, b)), dot(a, b)) * (180 / kPi);
}

void mark(const Surface& surface, std::uint32_t h, Seams& seams) {
  const std::uint32_t twin = surface.table.twin[h];
  if (twin != kNone) seams[h] = seams[twin] = 1;
}

void markSharp(const WeldedMesh& welded, const Surface& surface, double degrees, Seams& seams) {
  for (std::uint32_t h = 0; h < seams.size(); ++h) {
    const std::uint32_t twin = surface.table.twin[h];
    if (twin == kNone || twin < h || surface.triangulation.isDiagonal[h]) continue;
    const Vec3 a = normalOf(welded.mesh, surface, h / 3);
    const Vec3 b = normalOf(welded.mesh, surface, twin / 3);
    if (bend(a, b) > degrees) mark(surface, h, seams);
  }
}

/// By value: files may list a texcoord several times. No texcoord is a value of its own.
bool hasSameTexcoord(const CornerTexcoords& given, std::uint32_t cornerA, std::uint32_t cornerB) {
  const std::size_t a = given.ofCorner[cornerA], b = given.ofCorner[cornerB];
  if (a == kNoTexcoord || b == kNoTexcoord || a == b) return a == b;
  return given.texcoords[2 * a] == given.texcoords[2 * b] &&
         given.texcoords[2 * a + 1] == given.texcoords[2 * b + 1];
}

Status markIslands(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
                   Seams& seams) {
  if (input.faceTexcoords.empty())
    return {StatusCode::InvalidOption,
            "the mesh has no texcoords, so there are no islands to cut round; leave uv out of the "
            "seams"};
  const CornerTexcoords given{input.texcoords, input.faceTexcoords};
  for (std::uint32_t h = 0; h < seams.size(); ++h) {
    const std::uint32_t twin = surface.table.twin[h];
    if (twin == kNone || twin < h) continue;
    if (!hasSameTexcoords(given, welded, surface, h)) mark(surface, h, seams);
  }
  return {};
}

Status markMaterials(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
                     Seams& seams) {
  if (input.faceMaterials.empty())
    return {StatusCode::InvalidOption,
            "the mesh has no materials to cut between; leave material out of the seams"};
  for (std::uint32_t h = 0; h < seams.size(); ++h) {
    const std::uint32_t twin = surface.table.twin[h];
    if (twin == kNone || twin < h) continue;
    const auto material = [&](std::uint32_t c) {
      return input.faceMaterials[welded.inputFace[surface.triangulation.face[c / 3]]];
    };
    if (material(h) != material(twin)) mark(surface, h, seams);
  }
  return {};
}

std::string nameOf(const EdgeVertices& e) {
  return std::to_string(e[0]) + "-" + std::to_string(e[1]);
}

/// Vertices at one place are the same for an edge.
Status markEdges(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
                 const std::vector<EdgeVertices>& edges, Seams& seams) {
  struct Wanted {
    EdgeVertices places;
    std::size_t index;
    bool operator<(const Wanted& o) const { return places < o.places; }
  };
  std::vector<Wanted> wanted;
  for (const EdgeVertices& e : edges) {
    for (const std::uint32_t v : e)
      if (v >= input.vertexCount())
        return {StatusCode::InvalidOption, "the seam " + nameOf(e) + " names vertex " +
                                               std::to_string(v) + ", but there are only " +
                                               std::to_string(input.vertexCount())};
    wanted.push_back({sorted({welded.place[e[0]], welded.place[e[1]]}), wanted.size()});
  }
  std::sort(wanted.begin(), wanted.end());
  std::vector<std::uint8_t> isFound(edges.size(), 0);
  for (std::uint32_t h = 0; h < seams.size(); ++h) {
    if (surface.triangulation.isDiagonal[h]) continue;
    const std::uint32_t from = inputVertex(input, welded, surface, h),
                        to = inputVertex(input, welded, surface, nextCorner(h));
    const Wanted key{sorted({welded.place[from], welded.place[to]}), 0};
    auto found = std::lower_bound(wanted.begin(), wanted.end(), key);
    for (; found != wanted.end() && found->places == key.places; ++found) {
      isFound[found->index] = 1;
      mark(surface, h, seams);
    }
  }
  const auto missing = std::find(isFound.begin(), isFound.end(), 0);
  if (missing == isFound.end()) return {};
  return {StatusCode::InvalidOption,
          "the seam " + nameOf(edges[static_cast<std::size_t>(missing - isFound.begin())]) +
              " is no edge of a face"};
}

}  // namespace

bool hasSameTexcoords(const CornerTexcoords& given, const WeldedMesh& welded,
                      const Surface& surface, std::uint32_t h) {
  if (surface.triangulation.isDiagonal[h]) return true;
  const std::uint32_t twin = surface.table.twin[h];
  const auto corner = [&](std::uint32_t c) { return inputCorner(welded, surface, c); };
  return hasSameTexcoord(given, corner(h), corner(nextCorner(twin))) &&
         hasSameTexcoord(given, corner(nextCorner(h)), corner(twin));
}

Result<Seams> givenSeams(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
                         const SeamSources& sources) {
  Seams seams(surface.table.vertex.size(), 0);
  if (sources.sharpDegrees < 180) markSharp(welded, surface, sources.sharpDegrees, seams);
  if (sources.followsTexcoords)
    if (Status s = markIslands(input, welded, surface, seams); !s.ok()) return s;
  if (sources.followsMaterials)
    if (Status s = markMaterials(input, welded, surface, seams); !s.ok()) return s;
  if (Status s = markEdges(input, welded, surface, sources.edges, seams); !s.ok()) return s;
  return seams;
}

std::vector<EdgeVertices> seamEdges(const PolygonMesh& input, const WeldedMesh& welded,
                                    const Surface& surface, const Seams& seams) {
  std::vector<EdgeVertices> out;
  for (std::uint32_t h = 0; h < seams.size(); ++h)
    if (seams[h] && h < surface.table.twin[h])
      out.push_back(sorted({inputVertex(input, welded, surface, h),
                            inputVertex(input, welded, surface, nextCorner(h))}));
  return out;
}

}  // namespace abflat
