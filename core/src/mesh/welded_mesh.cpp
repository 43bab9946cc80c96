#include "mesh/welded_mesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/stable_order.h"
#include "mesh/corner_table.h"
#include "mesh/face_walk.h"
#include "mesh/open_corners.h"
#include "mesh/repeated_faces.h"
#include "mesh/triangle_geometry.h"
#include "mesh/weld.h"
#include "mesh/weld_edges.h"

namespace abflat {
namespace {

/// Gives faces that repeat others their own vertices: one for each vertex and layer.
void separateLayers(const Listener& listener, WeldedMesh& out) {
  const RepeatedFaces repeated = findRepeated(out.mesh, listener);
  if (listener.isStopped()) return;
  struct Copy {
    std::uint32_t vertex, layer, corner;
  };
  std::vector<Copy> copies;
  const auto inputFace = [&](std::uint32_t face) { return out.inputFace[PolygonFace(face)]; };
  for (std::uint32_t f = 0; f < out.mesh.faceCount(); ++f) {
    if (repeated.original[f] != kNone)
      out.duplicateFaces.push_back({inputFace(f), inputFace(repeated.original[f])});
    if (repeated.layer[f] == 0) continue;
    for (std::uint32_t c = out.mesh.faceOffsets[f]; c < out.mesh.faceOffsets[f + 1]; ++c)
      copies.push_back({out.mesh.faceVertices[c], repeated.layer[f], c});
  }
  sortStably(copies, [](const Copy& a, const Copy& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex
           : a.layer != b.layer ? a.layer < b.layer
                                : a.corner < b.corner;
  });
  for (std::size_t i = 0; i < copies.size(); ++i) {
    const Copy& c = copies[i];
    if (i == 0 || copies[i - 1].vertex != c.vertex || copies[i - 1].layer != c.layer)
      for (std::size_t d = 0; d < 3; ++d)
        out.mesh.positions.push_back(
            double{out.mesh.positions[3 * static_cast<std::size_t>(c.vertex) + d]});
    out.mesh.faceVertices[c.corner] = static_cast<std::uint32_t>(out.mesh.vertexCount() - 1);
  }
}

void addCorner(InputCorner c, std::uint32_t place, WeldedMesh& out) {
  out.cornerFor[c] = PolygonCorner(out.inputCorner.size());
  out.inputCorner.push_back(c);
  out.mesh.faceVertices.push_back(place);
}

void endFace(InputFace f, WeldedMesh& out) {
  out.inputFace.push_back(f);
  out.mesh.faceOffsets.push_back(static_cast<std::uint32_t>(out.mesh.faceVertices.size()));
}

/// Points corners that are left out of a face to those that stand for them. `begin`: the face's
/// first corner.
void findCornersFor(const FaceWalk& walk, std::uint32_t begin, WeldedMesh& out) {
  if (walk.corners.size() == walk.same.size()) return;
  const auto cornerFor = [&](std::uint32_t k) -> PolygonCorner& {
    return out.cornerFor[InputCorner(begin + k)];
  };
  for (std::uint32_t k = 0; k < walk.same.size(); ++k) {
    std::uint32_t other = k;
    while (!cornerFor(other).exists() && walk.same[other] != other) other = walk.same[other];
    cornerFor(k) = cornerFor(other);
  }
}

void addFace(InputFace f, const std::vector<std::uint32_t>& places, const PolygonMesh& mesh,
             WeldedMesh& out) {
  InputCorner c(mesh.faceOffsets[f]);
  for (const std::uint32_t place : places) {
    addCorner(c, place, out);
    ++c;
  }
  endFace(f, out);
}

/// Adds a face that visits places more than once.
void addWalk(InputFace f, const std::vector<std::uint32_t>& places, const PolygonMesh& mesh,
             OpenedCorners& opened, WeldedMesh& out) {
  const std::uint32_t begin = mesh.faceOffsets[f];
  const FaceWalk walk = walkAround(mesh.positions, places);
  if (walk.corners.size() < 3) {
    out.collapsedFaces.push_back(f);
    return;
  }
  const Opening& opening = walk.opening;
  if (!opening.points.empty() || walk.corners.size() < places.size()) out.splitFaces.push_back(f);
  const auto first = static_cast<std::uint32_t>(opened.positions.size() / 3);
  for (const auto& [corner, point] : opening.corners)
    opened.corners.push_back(
        {PolygonCorner(out.inputCorner.size() + corner), point == kNone ? kNone : first + point});
  for (const Vec3& p : opening.points)
    opened.positions.insert(opened.positions.end(), p.begin(), p.end());
  for (const std::uint32_t k : walk.corners) addCorner(InputCorner(begin + k), places[k], out);
  findCornersFor(walk, begin, out);
  endFace(f, out);
}

}  // namespace

WeldedMesh weld(const PolygonMesh& mesh, bool byPosition, const Listener& listener,
                const VertexPairs& joined) {
  std::vector<std::uint32_t> place(mesh.vertexCount());  // per vertex the first one there
  if (byPosition)
    place = weldSurface(mesh, listener).ofVertex;
  else
    std::iota(place.begin(), place.end(), 0u);
  place = weldEdges(mesh, listener, joinVertices(joined, std::move(place)));
  WeldedMesh out;
  for (std::uint32_t v = 0; v < place.size(); ++v) out.mergedVertices += place[v] != v;
  out.mesh.positions = mesh.positions;
  out.mesh.faceOffsets.push_back(0);
  out.mesh.faceVertices.reserve(mesh.faceVertices.size());
  out.inputCorner.reserve(mesh.faceVertices.size());
  out.cornerFor.assign(mesh.faceVertices.size(), {});
  OpenedCorners opened;
  std::vector<std::uint32_t> places;
  std::vector<std::uint32_t> lastFace(mesh.vertexCount(), kNone);
  for (std::uint32_t f = 0; f < mesh.faceCount() && listener.beat(); ++f) {
    bool visitsTwice = false;
    places.clear();
    for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c) {
      places.push_back(place[mesh.faceVertices[c]]);
      visitsTwice = visitsTwice || lastFace[places.back()] == f;
      lastFace[places.back()] = f;
    }
    if (visitsTwice)
      addWalk(InputFace(f), places, mesh, opened, out);
    else
      addFace(InputFace(f), places, mesh, out);
  }
  if (listener.isStopped()) return out;
  separateLayers(listener, out);
  openCorners(opened, out.mesh);
  out.firstAtPlace.reserve(place.size());
  for (const std::uint32_t v : place) out.firstAtPlace.push_back(InputVertex(v));
  return out;
}

}  // namespace abflat
