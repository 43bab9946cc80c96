#include "abflat/corner_frames.h"

#include <array>
#include <cmath>

#include "catch.h"

using namespace abflat;

namespace {

using Frames = std::vector<float>;

/// Two triangles of a square in the plane z = 0, with uv that lie as it does (v downwards).
struct Square {
  std::vector<std::uint32_t> corners = {0, 1, 2, 0, 2, 3};
  std::vector<bool> isTurned = {false, false};
  std::vector<double> positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  Frames normals = Frames(12), tangents;
  std::vector<FramePart> parts = {{0, 2}};

  FrameMesh mesh() const { return {corners, isTurned, positions, normals, tangents, parts}; }
  /// Of the corners as they are now.
  std::vector<double> uv() const {
    std::vector<double> out;
    for (std::size_t f = 0; f < 2; ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t v = mesh().vertex(f, k);
        out.insert(out.end(), {positions[3 * v], 1 - positions[3 * v + 1]});
      }
    return out;
  }
};

void checkAll(const Frames& found, std::size_t size, const std::vector<float>& expected) {
  REQUIRE(found.size() == 6 * size);
  for (std::size_t i = 0; i < found.size(); ++i)
    CHECK(found[i] == Approx(expected[i % size]).margin(1e-6));
}

}  // namespace

TEST_CASE("corners have the unit normal of their vertex, or that across their triangle") {
  Square square;
  checkAll(cornerNormals(square.mesh()), 3, {0, 0, 1});
  square.parts[0].isMirrored = true;
  checkAll(cornerNormals(square.mesh()), 3, {0, 0, -1});
  for (std::size_t v = 0; v < 4; ++v) square.normals[3 * v] = 5;
  checkAll(cornerNormals(square.mesh()), 3, {1, 0, 0});
}

TEST_CASE("tangents point to where u grows, and the sign tells where v shrinks") {
  const Square square;
  const Frames normals = cornerNormals(square.mesh());
  checkAll(oldTangents(square.mesh(), square.uv(), normals), 4, {1, 0, 0, 1});
  checkAll(newTangents(square.mesh(), square.uv(), normals), 4, {1, 0, 0, 1});
}

TEST_CASE("a turned triangle has the old tangents that it was drawn with") {
  Square square;
  for (std::size_t v = 0; v < 4; ++v) square.normals[3 * v + 2] = 1;
  const Frames normals = cornerNormals(square.mesh());
  const Frames before = oldTangents(square.mesh(), square.uv(), normals);
  square.isTurned = {true, true};
  CHECK(square.mesh().vertex(0, 1) == 2);
  CHECK(oldTangents(square.mesh(), square.uv(), normals) == before);
}

TEST_CASE("given tangents count before, not after") {
  Square square;
  const Frames normals = cornerNormals(square.mesh());
  for (std::size_t v = 0; v < 4; ++v) square.tangents.insert(square.tangents.end(), {0, 1, 0, -1});
  const std::vector<double> uv = square.uv();
  checkAll(oldTangents(square.mesh(), uv, normals), 4, {1, 0, 0, 1});
  square.parts[0].hasTangents = true;
  checkAll(oldTangents(square.mesh(), uv, normals), 4, {0, 1, 0, -1});
  checkAll(newTangents(square.mesh(), uv, normals), 4, {1, 0, 0, 1});
}
