#include <algorithm>

#include "abflat/draw.h"
#include "abflat/unwrap.h"
#include "catch.h"
#include "draw/atlas_polygons.h"
#include "draw/colours.h"
#include "draw/face_areas.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

UnwrapResult unwrapped(const PolygonMesh& mesh) {
  Result<UnwrapResult> r = unwrap(mesh, {});
  REQUIRE(r.ok());
  return std::move(r.value());
}

}  // namespace

TEST_CASE("edges of an atlas: each once, seams twice as outlines") {
  for (const PolygonMesh& mesh : {tetrahedron(), torus(24, 12), cylinder(12, 6)}) {
    const UnwrapResult r = unwrapped(mesh);
    const AtlasPolygons polygons = atlasPolygons(mesh, r);
    CHECK(polygons.count() == mesh.faceCount());
    const AtlasEdges edges = atlasEdges(polygons, r.cornerUv);
    CHECK(2 * edges.inner.size() + edges.outline.size() == mesh.faceVertices.size());
    std::size_t boundary = 0;
    for (const UnwrapChart& chart : r.report.charts) boundary += chart.boundaryVertices;
    CHECK(edges.outline.size() == boundary);
    std::vector<int> ends(r.uv.size() / 2, 0);
    for (const auto& [from, to] : edges.outline) ++ends[from], --ends[to];
    CHECK(std::all_of(ends.begin(), ends.end(), [](int n) { return n == 0; }));
  }
}

TEST_CASE("faces that collapsed are not drawn, and those that touch themselves are one polygon") {
  // A square polygon with a needle, two triangles that meet in a point, and an empty face.
  PolygonMesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 5, 5,
                    0, 6, 5, 0, 6, 6, 0, 4, 5, 0, 4, 4, 0};
  mesh.faceVertices = {0, 1, 2, 2, 3, 4, 5, 6, 4, 7, 8, 0, 1, 0};
  mesh.faceOffsets = {0, 5, 11, 14};
  const UnwrapResult r = unwrapped(mesh);
  const AtlasPolygons polygons = atlasPolygons(mesh, r);
  CHECK(polygons.face == std::vector<std::uint32_t>{0, 1});
  CHECK(polygons.offsets == std::vector<std::uint32_t>{0, 5, 11});
  const FaceAreas areas = faceAreas(mesh, r);
  CHECK(areas.in3d[0] == Approx(1));
  CHECK(areas.in3d[1] == Approx(1));
  CHECK(areas.in3d[2] == 0);
  CHECK(areas.inUv[0] == Approx(areas.inUv[1]).epsilon(0.01));  // the point is opened a little
  CHECK(areas.sum == Approx(2));
}

TEST_CASE("colours of ratios are as documented") {
  CHECK(colourText(ratioColour(1e-300)) == "#2166ac");
  CHECK(colourText(ratioColour(0.5)) == "#2166ac");
  CHECK(colourText(ratioColour(0.70710678)) == "#8cafd2");
  CHECK(colourText(ratioColour(1)) == "#f7f7f7");
  CHECK(colourText(ratioColour(1.41421356)) == "#d58891");
  CHECK(colourText(ratioColour(2)) == "#b2182b");
  CHECK(colourText(ratioColour(1e300)) == "#b2182b");
}

TEST_CASE("charts whose numbers are near have colours that differ") {
  for (std::uint32_t i = 0; i < 100; ++i)
    for (std::uint32_t j = i + 1; j < i + 6; ++j) {
      const Rgb a = chartColour(i), b = chartColour(j);
      float most = 0;
      for (std::size_t d = 0; d < 3; ++d) {
        most = std::max(most, std::abs(a[d] - b[d]));
        CHECK(a[d] >= 0.5f);
        CHECK(a[d] <= 1.0f);
      }
      INFO(i << " " << j);
      CHECK(most > 0.05f);
    }
}

TEST_CASE("no picture in pixels of an atlas that is too large") {
  UnwrapResult r = unwrapped(tetrahedron());
  CHECK(atlasPng(tetrahedron(), r).ok());
  r.report.atlas.width = kMostPictureTexels + 1;
  CHECK(atlasPng(tetrahedron(), r).status().code == StatusCode::InvalidOption);
  CHECK(heatMapPng(tetrahedron(), r).status().code == StatusCode::InvalidOption);
}
