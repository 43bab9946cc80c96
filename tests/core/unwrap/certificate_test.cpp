#include <cmath>
#include <random>

#include "abflat/io.h"
#include "abflat/unwrap.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

PolygonMesh together(const std::vector<PolygonMesh>& parts) {
  std::vector<double> positions;
  std::vector<std::uint32_t> indices;
  for (const PolygonMesh& part : parts) {
    const auto first = static_cast<std::uint32_t>(positions.size() / 3);
    positions.insert(positions.end(), part.positions.begin(), part.positions.end());
    for (const std::uint32_t v : part.faceVertices) indices.push_back(first + v);
  }
  return makeTriangleMesh(positions, indices);
}

PolygonMesh inUnit(PolygonMesh mesh, int exponent) {
  for (double& x : mesh.positions) x = std::ldexp(x, exponent);
  return mesh;
}

/// A planar strip with a vertex so close to an edge that its triangle is a needle.
PolygonMesh gridWithNeedle(double width, unsigned seed) {
  PolygonMesh mesh = bumpyGrid(6, 6, 0.2, seed);
  const std::size_t last = mesh.faceCount() / 2;
  const std::uint32_t* v = &mesh.faceVertices[3 * last];
  const auto middle = static_cast<std::uint32_t>(mesh.vertexCount());
  for (std::size_t d = 0; d < 3; ++d) {
    const double a = mesh.positions[3 * v[0] + d], b = mesh.positions[3 * v[1] + d];
    const double c = mesh.positions[3 * v[2] + d];
    mesh.positions.push_back((a + b) / 2 + width * (c - (a + b) / 2));
  }
  std::vector<std::uint32_t> indices = mesh.faceVertices;
  const std::uint32_t a = indices[3 * last], b = indices[3 * last + 1], c = indices[3 * last + 2];
  indices.resize(3 * last);
  indices.insert(indices.end(), mesh.faceVertices.begin() + 3 * static_cast<long>(last) + 3,
                 mesh.faceVertices.end());
  for (const std::uint32_t i : {a, b, middle, b, c, middle, c, a, middle}) indices.push_back(i);
  return makeTriangleMesh(mesh.positions, indices);
}

bool mentions(const UnwrapReport& report, const std::string& words) {
  for (const std::string& note : report.notes)
    if (note.find(words) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("a power of two in the unit changes no digit of an atlas", "[certificate]") {
  for (const PolygonMesh& mesh :
       {torus(12, 8), bumpyGrid(9, 9, 0.5, 3),
        together({tetrahedron(), transformed(tetrahedron(), 0.3, {4, 0, 0})})}) {
    const UnwrapResult expected = unwrapped(mesh, severalCharts());
    for (const int exponent : {-1000, -600, -1, 1, 30, 600, 1000}) {
      INFO(exponent);
      const UnwrapResult now = unwrapped(inUnit(mesh, exponent), severalCharts());
      CHECK(now.uv == expected.uv);
      CHECK(now.cornerUv == expected.cornerUv);
      CHECK(now.triangles == expected.triangles);
      for (std::size_t i = 0; i < now.unpacked.size(); ++i)
        CHECK(now.unpacked[i] == std::ldexp(expected.unpacked[i], exponent));
      CHECK(now.report.atlas.texelDensity ==
            std::ldexp(expected.report.atlas.texelDensity, -exponent));
      CHECK(now.report.symmetricDirichlet == expected.report.symmetricDirichlet);
    }
  }
}

TEST_CASE("a texel density is one of the mesh's unit, however large that is", "[certificate]") {
  UnwrapOptions options = severalCharts();
  options.texelDensity = 5;
  const PolygonMesh mesh = torus(12, 8);
  const UnwrapResult expected = unwrapped(mesh, options);
  for (const int exponent : {-700, 700}) {
    options.texelDensity = std::ldexp(5.0, -exponent);
    CHECK(unwrapped(inUnit(mesh, exponent), options).uv == expected.uv);
  }
  // Far too low: charts are enlarged until their triangles can be told apart.
  options.texelDensity = 1;
  const UnwrapResult tiny = unwrapped(inUnit(mesh, -700), options);
  CHECK(mentions(tiny.report, "enlarged"));
  // Far too high: rejected, with a density that does fit.
  const Result<UnwrapResult> huge = unwrap(inUnit(mesh, 700), options);
  REQUIRE(huge.status().code == StatusCode::AtlasTooSmall);
  const std::string words = "Lower the density to ";
  const std::size_t at = huge.status().message.find(words);
  REQUIRE(at != std::string::npos);
  options.texelDensity = std::stod(huge.status().message.substr(at + words.size()));
  unwrapped(inUnit(mesh, 700), options);
}

TEST_CASE("a layout that is known is known in any unit", "[certificate]") {
  const PolygonMesh mesh = inUnit(torus(12, 8), -600);
  UnwrapOptions options = severalCharts();
  // Charts that are cut by packing or for padding are flattened again.
  options.minUtilization = 0;
  options.padding = 0;
  const UnwrapResult first = unwrapped(mesh, options);
  options.reuse.known = knownLayout(first);
  const UnwrapResult again = unwrapped(mesh, options);
  CHECK(again.uv == first.uv);
  for (const UnwrapChart& chart : again.report.charts) CHECK(chart.solver == Solver::Known);
}

TEST_CASE("needles in a chart are valid in single precision", "[certificate]") {
  int moved = 0;
  for (const double width : {1e-8, 1e-10})
    for (unsigned seed = 1; seed <= 10; ++seed) {
      INFO(width << " " << seed);
      UnwrapOptions options;
      options.precision = Precision::Gltf;
      const UnwrapResult result = unwrapped(gridWithNeedle(width, seed), options);
      moved += mentions(result.report, "moved by up to");
      CHECK_FALSE(mentions(result.report, "enlarged"));
    }
  CHECK(moved > 0);
}

TEST_CASE("tiny charts beside large ones are enlarged, and only they", "[certificate]") {
  const PolygonMesh large = torus(12, 8);
  std::vector<PolygonMesh> parts = {large};
  for (int i = 0; i < 40; ++i)
    parts.push_back(
        transformed(bumpyGrid(3, 3, 0.3, static_cast<unsigned>(i)), 1e-8, {3.0 + i, 0.5 * i, 1}));
  UnwrapOptions options;
  options.precision = Precision::Gltf;
  options.texelDensity = 40;
  const UnwrapResult result = unwrapped(together(parts), options);
  CHECK(mentions(result.report, "tiny charts are enlarged"));
  CHECK(result.report.atlas.texelDensity == 40);
  // The areas of the other triangles are those of the surface times the density.
  const std::size_t triangles = large.faceCount();
  double area = 0, surface = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    const double* p[3];
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = &result.uv[2 * std::size_t{result.cornerUv[result.triangleCorners[3 * t + k]]}];
    area +=
        ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0])) / 2;
  }
  for (const UnwrapChart& chart : result.report.charts)
    if (chart.firstFace < triangles) surface += chart.area;
  const double density = 40.0 / options.resolution.width;
  CHECK(area == Approx(surface * density * density).epsilon(1e-3));
}

TEST_CASE("polygons that fans would fold are named", "[certificate]") {
  UnwrapOptions options;
  const UnwrapResult result = unwrapped(star(5), options);
  const UnwrapResult convex = unwrapped(torus(12, 8), options);
  CHECK(mentions(result.report, "1 polygon folds"));
  CHECK_FALSE(mentions(convex.report, "fold"));
}
