#include "seam/given_seams.h"

#include <algorithm>

#include "base/stable_order.h"
#include "seam/bend.h"

namespace abflat {
namespace {

EdgeVertices sorted(EdgeVertices e) {
  if (e[0] > e[1]) std::swap(e[0], e[1]);
  return e;
}

void mark(const Surface& surface, SurfaceCorner h, Seams& seams) {
  const SurfaceCorner twin = surface.table.twin[h];
  if (twin.exists()) seams[h] = seams[twin] = 1;
}

/// Calls visit(half-edge, twin) once for each edge with two sides.
template <class Visit>
void forEachInnerEdge(const Surface& surface, const Visit& visit) {
  for (const SurfaceCorner h : surface.table.corners()) {
    const SurfaceCorner twin = surface.table.twin[h];
    if (twin.exists() && h < twin) visit(h, twin);
  }
}

void markSharp(const SurfaceMap& map, double degrees, Seams& seams) {
  const Surface& surface = map.surface();
  forEachInnerEdge(surface, [&](SurfaceCorner h, SurfaceCorner twin) {
    if (surface.triangulation.isDiagonal[h]) return;
    const Vec3 a = facetNormal(map, triangleOf(h)), b = facetNormal(map, triangleOf(twin));
    if (bendBetween(a, b) > degrees) mark(surface, h, seams);
  });
}

Status markHard(const Seams& hard, Seams& seams) {
  if (hard.empty())
    return {StatusCode::InvalidOption,
            "the mesh has neither normals nor smoothing groups that say which edges are hard; the "
            "normals of STL facets do not. Use sharp=30 in place of hard"};
  for (const SurfaceCorner h : hard.ids()) seams[h] = seams[h] || hard[h];
  return {};
}

/// Compares values, since files may list a texcoord several times. A missing texcoord counts as a
/// value of its own.
bool hasSameTexcoord(const CornerTexcoords& given, InputCorner cornerA, InputCorner cornerB) {
  const std::size_t a = given.ofCorner[cornerA], b = given.ofCorner[cornerB];
  if (a == kNoTexcoord || b == kNoTexcoord || a == b) return a == b;
  return given.texcoords[2 * a] == given.texcoords[2 * b] &&
         given.texcoords[2 * a + 1] == given.texcoords[2 * b + 1];
}

Status markIslands(const SurfaceMap& map, Seams& seams) {
  const PolygonMesh& input = map.input().extras();
  if (input.faceTexcoords.empty())
    return {
        StatusCode::InvalidOption,
        "the mesh has no texcoords, so there are no uv islands to cut around. Leave uv out of the "
        "seams"};
  const CornerTexcoords given{input.texcoords, input.faceTexcoords};
  forEachInnerEdge(map.surface(), [&](SurfaceCorner h, SurfaceCorner) {
    if (!hasSameTexcoords(given, map, h)) mark(map.surface(), h, seams);
  });
  return {};
}

Status markMaterials(const SurfaceMap& map, Seams& seams) {
  const PolygonMesh& input = map.input().extras();
  if (input.faceMaterials.empty())
    return {StatusCode::InvalidOption,
            "the mesh has no materials to cut between. Leave material out of the seams"};
  const auto material = [&](SurfaceCorner c) {
    return input.faceMaterials[map.face(triangleOf(c))];
  };
  forEachInnerEdge(map.surface(), [&](SurfaceCorner h, SurfaceCorner twin) {
    if (material(h) != material(twin)) mark(map.surface(), h, seams);
  });
  return {};
}

std::string nameOf(const EdgeVertices& e) {
  return std::to_string(e[0]) + "-" + std::to_string(e[1]);
}

/// Coincident vertices are the same here.
Status markEdges(const SurfaceMap& map, const std::vector<EdgeVertices>& edges, Seams& seams) {
  const InputMesh& input = map.input();
  const auto firstAtPlace = [&](std::uint32_t v) {
    return map.welded().firstAtPlace[InputVertex(v)];
  };
  struct Wanted {
    EdgeVertices places;
    std::size_t index;
    bool operator<(const Wanted& o) const { return places < o.places; }
  };
  std::vector<Wanted> wanted;
  for (const EdgeVertices& e : edges) {
    for (const std::uint32_t v : e)
      if (v >= input.vertexCount())
        return {StatusCode::InvalidOption, "seam " + nameOf(e) + " refers to vertex " +
                                               std::to_string(v) + ", but there are only " +
                                               std::to_string(input.vertexCount())};
    wanted.push_back({sorted({firstAtPlace(e[0]), firstAtPlace(e[1])}), wanted.size()});
  }
  sortStably(wanted, std::less<>());
  std::vector<std::uint8_t> isFound(edges.size(), 0);
  const Surface& surface = map.surface();
  for (const SurfaceCorner h : surface.table.corners()) {
    if (surface.triangulation.isDiagonal[h]) continue;
    const InputVertex from = map.vertex(h), to = map.vertex(nextCorner(h));
    const Wanted key{sorted({firstAtPlace(from), firstAtPlace(to)}), 0};
    auto found = std::lower_bound(wanted.begin(), wanted.end(), key);
    for (; found != wanted.end() && found->places == key.places; ++found) {
      isFound[found->index] = 1;
      mark(surface, h, seams);
    }
  }
  const auto missing = std::find(isFound.begin(), isFound.end(), 0);
  if (missing == isFound.end()) return {};
  return {StatusCode::InvalidOption,
          "seam " + nameOf(edges[static_cast<std::size_t>(missing - isFound.begin())]) +
              " is not an edge of any face"};
}

}  // namespace

bool hasSameTexcoords(const CornerTexcoords& given, const SurfaceMap& map, SurfaceCorner h) {
  if (map.surface().triangulation.isDiagonal[h]) return true;
  const SurfaceCorner twin = map.surface().table.twin[h];
  return hasSameTexcoord(given, map.corner(h), map.corner(nextCorner(twin))) &&
         hasSameTexcoord(given, map.corner(nextCorner(h)), map.corner(twin));
}

Result<Seams> givenSeams(const SurfaceMap& map, const SeamSources& sources, const Seams& hard) {
  Seams seams(map.surface().table.vertex.size(), 0);
  if (sources.sharpDegrees < 180) markSharp(map, sources.sharpDegrees, seams);
  if (sources.followsHardEdges)
    if (Status s = markHard(hard, seams); !s.ok()) return s;
  if (sources.followsTexcoords)
    if (Status s = markIslands(map, seams); !s.ok()) return s;
  if (sources.followsMaterials)
    if (Status s = markMaterials(map, seams); !s.ok()) return s;
  if (Status s = markEdges(map, sources.edges, seams); !s.ok()) return s;
  return seams;
}

std::vector<EdgeVertices> seamEdges(const SurfaceMap& map, const Seams& seams) {
  std::vector<EdgeVertices> out;
  for (const SurfaceCorner h : map.surface().table.corners())
    if (seams[h] && h < map.surface().table.twin[h])
      out.push_back(sorted({map.vertex(h), map.vertex(nextCorner(h))}));
  return out;
}

}  // namespace abflat
