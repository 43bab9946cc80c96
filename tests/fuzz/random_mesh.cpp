#include "random_mesh.h"

#include <cmath>
#include <utility>

#include "shapes.h"

namespace abflat::fuzz {
namespace {

std::uint32_t anyVertex(const Shape& shape, RandomSource& random) {
  return random.below(shape.points.size());
}

std::vector<std::uint32_t>& anyFace(Shape& shape, RandomSource& random) {
  return shape.faces[random.below(shape.faces.size())];
}

void turnOver(Shape& shape, RandomSource& random) {
  std::vector<std::uint32_t>& face = anyFace(shape, random);
  face.assign(face.rbegin(), face.rend());
}

void repeatFace(Shape& shape, RandomSource& random) {
  shape.faces.push_back(std::vector<std::uint32_t>(anyFace(shape, random)));
}

void removeFace(Shape& shape, RandomSource& random) {
  if (shape.faces.size() < 2) return;
  std::swap(anyFace(shape, random), shape.faces.back());
  shape.faces.pop_back();
}

void joinVertices(Shape& shape, RandomSource& random) {
  const std::uint32_t from = anyVertex(shape, random), to = anyVertex(shape, random);
  for (auto& face : shape.faces)
    for (std::uint32_t& v : face)
      if (v == from) v = to;
}

/// At the place of another one, or all but there.
void moveVertex(Shape& shape, RandomSource& random) {
  const Point to = shape.points[anyVertex(shape, random)];
  Point& p = shape.points[anyVertex(shape, random)];
  const double rest = random.pick({0.0, 1e-16, 1e-9, 1e-5});
  for (std::size_t d = 0; d < 3; ++d) p[d] = to[d] + rest * p[d];
}

void separateCorner(Shape& shape, RandomSource& random) {
  auto& face = anyFace(shape, random);
  std::uint32_t& v = face[random.below(face.size())];
  v = shape.add(Point(shape.points[v]));
}

void separateAll(Shape& shape) {
  Shape out;
  for (const auto& face : shape.faces) {
    out.faces.emplace_back();
    for (const std::uint32_t v : face) out.faces.back().push_back(out.add(shape.points[v]));
  }
  shape = std::move(out);
}

void addFace(Shape& shape, RandomSource& random) {
  std::vector<std::uint32_t> face;
  for (std::uint32_t k = random.between(3, 6); k > 0; --k) face.push_back(anyVertex(shape, random));
  shape.faces.push_back(face);
}

void repeatCorner(Shape& shape, RandomSource& random) {
  auto& face = anyFace(shape, random);
  face.insert(face.begin() + random.below(face.size()), face[random.below(face.size())]);
}

void moveFarAway(Shape& shape, RandomSource& random) {
  const double far = random.pick({1e3, 1e9, 1e15});
  for (Point& p : shape.points)
    for (double& x : p) x += far;
}

void scale(Shape& shape, RandomSource& random) {
  const double factor = std::ldexp(1.0, 16 * (static_cast<int>(random.below(129)) - 64));
  for (Point& p : shape.points)
    for (double& x : p)
      if (const double scaled = x * factor; std::isfinite(scaled)) x = scaled;
}

void spoil(Shape& shape, RandomSource& random) {
  switch (random.below(13)) {
    case 0:
      return turnOver(shape, random);
    case 1:
      return repeatFace(shape, random);
    case 2:
      return removeFace(shape, random);
    case 3:
      return joinVertices(shape, random);
    case 4:
      return moveVertex(shape, random);
    case 5:
      return separateCorner(shape, random);
    case 6:
      return separateAll(shape);
    case 7:
      return addFace(shape, random);
    case 8:
      return repeatCorner(shape, random);
    case 9:
      return moveFarAway(shape, random);
    case 10:
      return scale(shape, random);
    case 11:  // used by no face
      shape.add({random.pick({0.0, 1e9, 1e300}), 0, random.signedUnit()});
      return;
    default:
      shape.points[anyVertex(shape, random)] = {random.signedUnit() * 1e6, 0, 1};
  }
}

Shape anyShape(RandomSource& random) {
  constexpr Shape (*kShapes[])(RandomSource&) = {bumpyNet,     sphere, ring, box,    city,
                                                 checkerboard, fan,    soup, tangle, polygon};
  return kShapes[random.below(std::size(kShapes))](random);
}

/// Texcoords as a file may have them: a projection, torn at some faces, missing at others.
void addTexcoords(PolygonMesh& mesh, RandomSource& random) {
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const bool isMissing = random.isOneOf(8);
    const double shift = random.isOneOf(4) ? random.signedUnit() : 0;
    for (std::size_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c) {
      const double* p = &mesh.positions[3 * std::size_t{mesh.faceVertices[c]}];
      mesh.faceTexcoords.push_back(
          isMissing ? kNoTexcoord : static_cast<std::uint32_t>(mesh.texcoords.size() / 2));
      if (!isMissing) mesh.texcoords.insert(mesh.texcoords.end(), {p[0] / 16 + shift, p[1] / 16});
    }
  }
}

void addMaterials(PolygonMesh& mesh, RandomSource& random) {
  mesh.materialNames = {"", "wood", "glass"};
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    mesh.faceMaterials.push_back(random.below(mesh.materialNames.size()));
}

}  // namespace

PolygonMesh randomMesh(RandomSource& random) {
  Shape shape = anyShape(random);
  for (std::uint32_t n = random.below(9); n > 0 && !shape.faces.empty() && !shape.points.empty();
       --n)
    spoil(shape, random);
  PolygonMesh mesh = shape.mesh();
  if (random.isOneOf(3)) addTexcoords(mesh, random);
  if (random.isOneOf(4)) addMaterials(mesh, random);
  return mesh;
}

PolygonMesh randomDisk(RandomSource& random) {
  constexpr Shape (*kShapes[])(RandomSource&) = {bumpyNet, fan, sphere, ring};
  Shape shape = kShapes[random.below(std::size(kShapes))](random);
  if (random.isOneOf(4)) moveVertex(shape, random);
  if (random.isOneOf(4)) scale(shape, random);
  return shape.mesh();
}

}  // namespace abflat::fuzz
