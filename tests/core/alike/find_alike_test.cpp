#include "alike/find_alike.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "catch.h"
#include "mesh/topology.h"
#include "support/copies.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// The components of a mesh, compared.
struct Compared {
  explicit Compared(PolygonMesh given, bool mayMirror = false)
      : mesh(std::move(given)), surface(buildSurface(mesh)), cells(cellsOfComponents()) {
    match = findAlike(cells, IdVector<PartId, std::uint8_t>(cells.parts, 0), mayMirror);
  }

  Cells cellsOfComponents() const {
    const Components components = findComponents(surface.table);
    IdVector<SurfaceTriangle, PartId> part;
    for (const ComponentId i : components.ofTriangle) part.push_back(PartId(std::uint32_t{i}));
    return cellsOf(mesh, surface.triangulation, part, surface.table.twin,
                   components.firstTriangle.size());
  }

  PartId partOf(PolygonCorner c) const { return cells.part[cells.face[c]]; }

  /// The parts that others lie on, or nothing.
  std::set<std::uint32_t> models() const {
    std::set<std::uint32_t> out;
    for (const PolygonCorner c : match.ids()) out.insert(partOf(match[c]));
    return out;
  }

  /// Whether corresponding corners are as far from each other in both parts, and neighbours remain
  /// neighbours.
  bool keepsShape(double tolerance) const {
    for (const PolygonCorner a : match.ids()) {
      const PolygonCorner b((7 * a + 5) % match.size());
      if (partOf(a) != partOf(b)) continue;
      if (std::abs(distanceBetween(cells.at(a), cells.at(b)) -
                   distanceBetween(cells.at(match[a]), cells.at(match[b]))) > tolerance)
        return false;
    }
    for (const PolygonCorner c : match.ids()) {
      if (partOf(match[c]) != partOf(match[*cells.corners(PolygonFace(cells.face[c])).begin()]))
        return false;
      const PolygonCorner next = match[cells.next(c)];
      if (next != cells.next(match[c]) && next != cells.prev(match[c])) return false;
    }
    return true;
  }

  std::size_t mirrored() const {
    std::set<std::uint32_t> out;
    for (const PolygonCorner c : match.ids())
      if (isMirroredAt(cells, match, c)) out.insert(partOf(c));
    return out.size();
  }

  PolygonMesh mesh;
  Surface surface;
  Cells cells;
  CornerMatch match;
};

PolygonMesh two(const PolygonMesh& a, const PolygonMesh& b) {
  PolygonMesh out;
  std::mt19937 random(3);
  append(out, a);
  append(out, moved(renumbered(b, 5).mesh, randomMotion(random, false), false));
  return out;
}

/// The surface of all unit blocks whose middles lie in a ball.
PolygonMesh blockBall(int radius) {
  PolygonMesh out;
  out.faceOffsets = {0};
  std::map<std::array<int, 3>, std::uint32_t> vertices;
  const auto isInside = [&](const std::array<int, 3>& p) {
    return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] <= radius * radius;
  };
  const auto addSide = [&](std::array<int, 3> block, std::size_t axis, int side) {
    for (const std::array<int, 2>& at : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      std::array<int, 3> p = block;
      p[axis] += side;
      p[(axis + (side ? 1 : 2)) % 3] += at[0];
      p[(axis + (side ? 2 : 1)) % 3] += at[1];
      const auto [it, isNew] = vertices.try_emplace(p, static_cast<std::uint32_t>(vertices.size()));
      if (isNew) out.positions.insert(out.positions.end(), p.begin(), p.end());
      out.faceVertices.push_back(it->second);
    }
    out.faceOffsets.push_back(static_cast<std::uint32_t>(out.faceVertices.size()));
  };
  for (int x = -radius; x <= radius; ++x)
    for (int y = -radius; y <= radius; ++y)
      for (int z = -radius; z <= radius; ++z)
        for (std::size_t axis = 0; axis < 3 && isInside({x, y, z}); ++axis)
          for (const int side : {0, 1}) {
            std::array<int, 3> beside = {x, y, z};
            beside[axis] += side ? 1 : -1;
            if (!isInside(beside)) addSide({x, y, z}, axis, side);
          }
  return out;
}

PolygonMesh shifted(PolygonMesh mesh, std::size_t vertex, double by) {
  mesh.positions[3 * vertex + 2] += by;
  return mesh;
}

/// Two unit squares that share an edge, with an angle between them.
PolygonMesh hinge(double angle) {
  PolygonMesh out;
  out.positions = {0,
                   0,
                   0,
                   1,
                   0,
                   0,
                   1,
                   1,
                   0,
                   0,
                   1,
                   0,
                   -std::cos(angle),
                   0,
                   std::sin(angle),
                   -std::cos(angle),
                   1,
                   std::sin(angle)};
  out.faceVertices = {0, 1, 2, 3, 4, 0, 3, 5};
  out.faceOffsets = {0, 4, 8};
  return out;
}

}  // namespace

TEST_CASE("copies are found, however they are moved, turned and numbered", "[alike]") {
  for (const PolygonMesh& mesh :
       {wedge(), torus(9, 6), bumpyGrid(6, 4, 0.4, 1), cone(40, 0.5), star(7)}) {
    const Compared found(copies(mesh, 12, 7));
    CHECK(found.models().size() == 1);
    CHECK(found.keepsShape(1e-4));
    CHECK(found.mirrored() == 0);
  }
}

TEST_CASE("mirror images are alike only if that is asked for", "[alike]") {
  const PolygonMesh mesh = copies(wedge(), 10, 2, true);
  const Compared turned(mesh), any(mesh, true);
  CHECK(turned.models().size() == 2);
  CHECK(turned.keepsShape(1e-4));
  CHECK(turned.mirrored() == 0);
  CHECK(any.models().size() == 1);
  CHECK(any.keepsShape(1e-4));
  CHECK(any.mirrored() == 5);
  // What is its own mirror image need not be mirrored.
  CHECK(Compared(copies(star(5), 4, 1, true), true).mirrored() == 0);
}

TEST_CASE("parts that differ by more than the tolerance are not alike", "[alike]") {
  const double radius = 2;  // of the wedge, about
  for (const std::size_t vertex : {0, 3, 6}) {
    CHECK(Compared(two(wedge(), shifted(wedge(), vertex, 1e-4 * radius))).models().size() == 1);
    CHECK(Compared(two(wedge(), shifted(wedge(), vertex, 1e-2 * radius)), true).models().size() ==
          2);
  }
}

TEST_CASE("parts of the same area, edges or form of mesh are not alike for that", "[alike]") {
  // The same edges, bent differently, or to the other side.
  CHECK(Compared(two(hinge(0.5), hinge(0.5))).models().size() == 1);
  CHECK(Compared(two(hinge(0.5), hinge(0.6)), true).models().size() == 2);
  CHECK(Compared(two(hinge(0.5), hinge(-0.5)), true).models().size() == 2);
  // The same area and mesh.
  PolygonMesh flat = hinge(0), sheared = hinge(0);
  for (std::size_t v = 0; v < 6; ++v)
    sheared.positions[3 * v] += 0.5 * sheared.positions[3 * v + 1];
  CHECK(Compared(two(flat, sheared), true).models().size() == 2);
  // The same surface, in other polygons.
  CHECK(Compared(two(star(5), cone(10, 0))).models().size() == 2);
}

TEST_CASE("marked edges and faces have to correspond", "[alike]") {
  const Compared found(two(wedge(), wedge()));
  const auto modelsWith = [&](const auto& mark) {
    Cells cells = found.cells;
    mark(cells);
    const CornerMatch match =
        findAlike(cells, IdVector<PartId, std::uint8_t>(cells.parts, 0), false);
    const auto isModel = [&](PolygonCorner c) { return match[c] == c; };
    return isModel(PolygonCorner(0)) && isModel(PolygonCorner(24)) ? 2 : 1;
  };
  PolygonCorner copy(0);
  if (found.match[copy] == copy) copy = PolygonCorner(24);
  const PolygonCorner model = found.match[copy];
  CHECK(modelsWith([](Cells&) {}) == 1);
  CHECK(modelsWith([&](Cells& c) { c.faceMark[c.face[copy]] = 1; }) == 2);
  CHECK(modelsWith([&](Cells& c) { c.faceMark[c.face[copy]] = c.faceMark[c.face[model]] = 1; }) ==
        1);
  const auto markEdge = [](Cells& c, PolygonCorner h) {
    c.edgeMark[h] = c.edgeMark[c.twin[h]] = 1;
  };
  CHECK(modelsWith([&](Cells& c) { markEdge(c, copy); }) == 2);
  CHECK(modelsWith([&](Cells& c) {
          markEdge(c, copy);
          markEdge(c, model);
        }) == 1);
}

TEST_CASE("which part is the model depends on its place, not on numbers", "[alike]") {
  const PolygonMesh mesh = copies(wedge(), 9, 4, true);
  const auto placeOfModel = [](const Compared& found) {
    std::array<double, 3> sum{};
    for (const PolygonCorner c : found.match.ids())
      if (found.match[c] == c)
        for (std::size_t d = 0; d < 3; ++d) sum[d] += found.cells.at(c)[d] / 24;
    return sum;
  };
  const auto first = placeOfModel(Compared(mesh, true));
  for (const unsigned seed : {1u, 2u, 3u}) {
    const auto other = placeOfModel(Compared(renumbered(mesh, seed).mesh, true));
    for (std::size_t d = 0; d < 3; ++d) CHECK(other[d] == Approx(first[d]).epsilon(1e-9));
  }
}

TEST_CASE("a symmetric part lies on another in any of many ways", "[alike]") {
  const Compared found(copies(cone(2000, 0.3), 3, 5));
  CHECK(found.models().size() == 1);
  CHECK(found.keepsShape(1e-4));
}

TEST_CASE("a round part without irregular polygons lies on another however it is turned",
          "[alike]") {
  const PolygonMesh ball = blockBall(14);
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Compared found(copies(ball, 3, seed, true), true);
    CHECK(found.models().size() == 1);
    CHECK(found.keepsShape(1e-4));
  }
}
