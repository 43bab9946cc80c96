#include "seam/part_maker.h"

#include <utility>

namespace abflat {

PartMaker::PartMaker(const SeamMesh& mesh) : mesh_(mesh), inPart_(mesh.twin.size()) {
  part_.mesh.frontLeeway = mesh.frontLeeway;
}

void PartMaker::reserve(std::size_t triangles, std::size_t vertices) {
  SeamMesh& m = part_.mesh;
  m.area.reserve(triangles);
  m.positions.reserve(3 * vertices);
  m.vertexArea.reserve(vertices);
  m.angleSum.reserve(vertices);
  part_.wholeVertex.reserve(vertices);
  part_.wholeHalfEdge.reserve(3 * triangles);
  m.vertexOfCorner.reserve(3 * triangles);
  m.twin.reserve(3 * triangles);
}

void PartMaker::addTriangle(SurfaceTriangle f) {
  SeamMesh& m = part_.mesh;
  m.area.push_back(mesh_.area[f]);
  if (!mesh_.hole.empty()) m.hole.push_back(mesh_.hole[f]);
  if (!mesh_.front.empty()) m.front.push_back(mesh_.frontAt(f));
  if (!mesh_.excess.empty()) m.excess.push_back(mesh_.excess[f]);
  for (const SurfaceCorner h : cornersOf(f)) inPart_[h] = part_.wholeHalfEdge.push_back(h);
}

SurfaceVertex PartMaker::addVertex(SurfaceVertex ofWhole) {
  const double* const p = &mesh_.positions[3 * std::size_t{ofWhole}];
  part_.mesh.positions.insert(part_.mesh.positions.end(), p, p + 3);
  part_.wholeVertex.push_back(ofWhole);
  part_.mesh.angleSum.push_back(0);
  return part_.mesh.vertexArea.push_back(0);
}

void PartMaker::addCorner(SurfaceCorner h, SurfaceVertex v, SurfaceCorner twin) {
  SeamMesh& m = part_.mesh;
  m.vertexOfCorner.push_back(v);
  m.twin.push_back(twin.exists() ? inPart_[twin] : SurfaceCorner());
  m.vertexArea[v] += mesh_.area[triangleOf(h)] / 3;
  m.angleSum[v] += mesh_.angle[h];
}

SeamPart PartMaker::take() {
  SeamMesh& m = part_.mesh;
  m.angle = part_.ofCorners(mesh_.angle);
  m.length = part_.ofCorners(mesh_.length);
  m.cost = part_.ofCorners(mesh_.cost);
  m.weight = part_.ofCorners(mesh_.weight);
  if (mesh_.dearness.empty()) return std::move(part_);
  m.dearness.resize(corners().size());
  for (const SurfaceCorner h : m.dearness.ids()) m.dearness[h] = mesh_.dearnessAt(corners()[h]);
  return std::move(part_);
}

}  // namespace abflat
