#include "mesh/surface.h"

#include <cmath>

#include "mesh/straight_pairs.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

std::string plural(std::size_t n, const char* noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

std::string edgeName(const BadEdge& e) {
  return "edge " + std::to_string(e.v0) + "-" + std::to_string(e.v1);
}

/// The first face that has the same vertex at two of its corners, or kNone.
std::uint32_t findRepeatedVertex(const PolygonMesh& mesh, std::uint32_t& vertex) {
  std::vector<std::uint32_t> lastFace(mesh.vertexCount(), kNone);
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    for (std::uint32_t k = mesh.faceOffsets[f]; k < mesh.faceOffsets[f + 1]; ++k) {
      vertex = mesh.faceVertices[k];
      if (lastFace[vertex] == f) return f;
      lastFace[vertex] = f;
    }
  return kNone;
}

Status diskStatus(const PolygonMesh& mesh, const Surface& s, const Components& components) {
  const MeshSummary& m = s.summary;
  if (m.faces == 0) return {StatusCode::EmptyMesh, "the mesh has no faces"};
  std::uint32_t vertex = kNone;
  if (const std::uint32_t f = findRepeatedVertex(mesh, vertex); f != kNone)
    return {StatusCode::DegenerateFace, "face " + std::to_string(f) + " uses vertex " +
                                            std::to_string(vertex) +
                                            " twice. Remove the face or split it"};
  if (!s.table.nonManifold.empty()) {
    const BadEdge& e = s.table.nonManifold.front();
    return {StatusCode::NonManifoldEdge, edgeName(e) + " has " + std::to_string(e.faceCount) +
                                             " faces (" + plural(m.nonManifoldEdges, "edge") +
                                             " with more than two). Use unwrap, which cuts there"};
  }
  if (!s.table.misoriented.empty()) {
    const BadEdge& e = s.table.misoriented.front();
    return {StatusCode::InconsistentOrientation,
            "face " + std::to_string(e.faces[1]) + " has opposite orientation to face " +
                std::to_string(e.faces[0]) + " at " + edgeName(e) + " (" +
                plural(m.orientationConflicts, "such edge") +
                "). Use unwrap, or reorient the faces"};
  }
  if (m.components > 1)
    return {StatusCode::MultipleComponents,
            plural(m.components, "component") +
                ". Use unwrap, or keep only one: the second begins at face " +
                std::to_string(s.triangulation.face[components.firstTriangle[ComponentId(1)]])};
  if (m.boundaryLoops == 0)
    return {StatusCode::ClosedSurface,
            "closed surface" + (m.genus > 0 ? " of genus " + std::to_string(m.genus) : "") +
                ". Use unwrap, which cuts it open"};
  if (m.genus > 0)
    return {StatusCode::HasHandles,
            "not a disk, so use unwrap: the surface has genus " + std::to_string(m.genus)};
  if (m.boundaryLoops > 1)
    return {StatusCode::MultipleBoundaryLoops,
            plural(m.boundaryLoops, "boundary loop") +
                ". Use unwrap, or close all but one: the second passes through vertex " +
                std::to_string(s.table.vertex[s.boundaryLoops[1].front()])};
  return {};
}

std::size_t countReferenced(const PolygonMesh& mesh) {
  std::vector<std::uint8_t> used(mesh.vertexCount(), 0);
  for (std::uint32_t v : mesh.faceVertices) used[v] = 1;
  std::size_t n = 0;
  for (std::uint8_t u : used) n += u;
  return n;
}

std::size_t countDegenerate(const PolygonMesh& mesh, const Triangulation& t) {
  std::size_t n = 0;
  PolygonFace last;
  for (const SurfaceTriangle f : t.face.ids())
    if (t.face[f] != last && isDegenerate(mesh.positions, verticesOf(t.vertex, f))) {
      ++n;
      last = t.face[f];
    }
  return n;
}

/// chi = V - E + F of the surface cut open at bad edges and touching vertices.
std::int64_t cutEulerCharacteristic(const Surface& s) {
  std::int64_t halfEdges = 0, boundary = 0;
  for (const SurfaceCorner twin : s.table.twin) twin.exists() ? ++halfEdges : ++boundary;
  return static_cast<std::int64_t>(s.fans.inputVertex.size()) - (halfEdges / 2 + boundary) +
         static_cast<std::int64_t>(s.table.triangles().size());
}

}  // namespace

Surface buildSurface(const PolygonMesh& mesh, const Listener& listener, const FineLength& fineOf) {
  Surface s;
  s.triangulation = triangulate(mesh, listener);
  if (listener.isStopped()) return {};
  s.table = buildCornerTable(s.triangulation, mesh.vertexCount(), listener);
  if (!s.table.nonManifold.empty())
    joinStraightPairs(mesh.positions, fineOf ? fineOf(s.table) : 0, s.table);
  // Each of the following passes takes some ten nanoseconds per triangle.
  if (!listener.beat(s.table.vertex.size())) return {};
  s.fans = findFans(s.table, mesh.vertexCount());
  if (!listener.beat(s.table.vertex.size())) return {};
  s.boundaryLoops = findBoundaryLoops(s.table);
  const Components components = findComponents(s.table);
  if (!listener.beat(s.table.vertex.size())) return {};

  MeshSummary& m = s.summary;
  const std::size_t referenced = countReferenced(mesh);
  m.vertices = mesh.vertexCount();
  m.unreferencedVertices = m.vertices - referenced;
  m.faces = mesh.faceCount();
  m.triangles = s.triangulation.face.size();
  m.components = components.firstTriangle.size();
  m.boundaryLoops = s.boundaryLoops.size();
  m.nonManifoldEdges = s.table.nonManifold.size();
  m.orientationConflicts = s.table.misoriented.size();
  m.degenerateFaces = countDegenerate(mesh, s.triangulation);

  std::int64_t openHalfEdges = 0, pairs = 0;  // of bad edges
  for (const auto* list : {&s.table.nonManifold, &s.table.misoriented})
    for (const BadEdge& e : *list) {
      openHalfEdges += e.faceCount - 2 * e.pairs;
      pairs += e.pairs;
    }
  std::size_t unpaired = 0;
  for (const SurfaceCorner twin : s.table.twin) unpaired += !twin.exists();
  m.boundaryEdges = unpaired - static_cast<std::size_t>(openHalfEdges);
  const auto bad = static_cast<std::int64_t>(m.nonManifoldEdges + m.orientationConflicts);
  const std::int64_t cutChi = cutEulerCharacteristic(s);
  m.eulerCharacteristic = cutChi -
                          static_cast<std::int64_t>(s.fans.inputVertex.size() - referenced) +
                          (openHalfEdges + pairs - bad);
  m.genus = bad > 0 ? -1
                    : (2 * static_cast<std::int64_t>(m.components) -
                       static_cast<std::int64_t>(m.boundaryLoops) - cutChi) /
                          2;
  m.disk = diskStatus(mesh, s, components);
  return s;
}

}  // namespace abflat
