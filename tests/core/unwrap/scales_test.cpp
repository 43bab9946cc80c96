#include <random>
#include <string>
#include <vector>

#include "abflat/unwrap.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

std::string notesOf(const UnwrapResult& r) {
  std::string out;
  for (const std::string& note : r.report.notes) out += note + "\n";
  return out;
}

PolygonMesh withVertexAt(PolygonMesh mesh, std::size_t vertex, double distance) {
  const double direction[3] = {0.48, -0.64, 0.6};
  for (std::size_t d = 0; d < 3; ++d) mesh.positions[3 * vertex + d] += distance * direction[d];
  return mesh;
}

}  // namespace

TEST_CASE("a vertex far off leaves the others an atlas that is valid, in every precision",
          "[unwrap]") {
  for (const PolygonMesh& mesh : {torus(24, 16), bumpyGrid(12, 10, 0.5, 1)})
    for (const double distance : {1e2, 1e4, 1e5, 1e6, 1e7, 1e9, 1e12})
      for (const bool isGltf : {false, true}) {
        UnwrapOptions options;
        options.precision = isGltf ? Precision::Gltf : Precision::Single;
        INFO(distance << (isGltf ? " glTF" : ""));
        const Result<UnwrapResult> r = unwrap(withVertexAt(mesh, 77, distance), options);
        REQUIRE(r.ok());
        INFO(notesOf(r.value()));
        CHECK(r.value().report.valid);
        const bool isCut = notesOf(r.value()).find("cut apart") != std::string::npos;
        // At that distance, one of the two meshes has faces 2^16 times as long as others.
        if (distance != 1e5) CHECK(isCut == (distance > 1e5));
      }
}

TEST_CASE("a part beside one of another scale has the charts that it has alone", "[unwrap]") {
  const PolygonMesh small = torus(24, 16);
  UnwrapOptions options;
  options.minUtilization = 0;  // two charts are packed differently from one
  const std::size_t alone = unwrapped(small, options).report.charts.size();
  for (const double scale : {1e3, 1e8, 1e16, 1e30, 1e150}) {
    INFO(scale);
    PolygonMesh both = small;
    for (const double x : small.positions) both.positions.push_back(scale * (x + 3));
    const auto vertices = static_cast<std::uint32_t>(small.vertexCount());
    for (const std::uint32_t v : small.faceVertices) both.faceVertices.push_back(v + vertices);
    both = makeTriangleMesh(both.positions, both.faceVertices);
    const UnwrapResult r = unwrapped(both, options);
    CHECK(r.report.charts.size() == 2 * alone);
    CHECK(notesOf(r).find("stretched") == std::string::npos);
    CHECK(notesOf(r).find("cut apart") == std::string::npos);
  }
}

TEST_CASE("few faces that are tiny stay with their neighbours", "[unwrap]") {
  PolygonMesh mesh = torus(40, 24);
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t a = mesh.faceVertices[300], b = mesh.faceVertices[301];
    mesh.positions[3 * a + d] =
        mesh.positions[3 * b + d] + 1e-9 * (mesh.positions[3 * a + d] - mesh.positions[3 * b + d]);
  }
  const UnwrapResult r = unwrapped(mesh, {});
  CHECK(notesOf(r).find("cut apart") == std::string::npos);
}

TEST_CASE(
    "most fans of needles that are thinner than single precision tells are widened until they are "
    "valid",
    "[unwrap]") {
  int valid = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const auto small = [&] { return 0.1 * static_cast<double>(random() % 1000) / 1000; };
    const std::uint32_t n = 4 + seed % 5;
    std::vector<double> p{7e6, -9e6, 8e6};
    for (std::uint32_t i = 0; i < 2 * n + 1; ++i) p.insert(p.end(), {small(), small(), small()});
    PolygonMesh mesh;
    mesh.positions = p;
    mesh.faceOffsets = {0};
    for (std::uint32_t i = 1; i < 2 * n; i += 2) {
      for (const std::uint32_t v : {0u, i, i + 1, i + 2}) mesh.faceVertices.push_back(v);
      mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
    }
    UnwrapOptions options;
    options.precision = Precision::Gltf;
    valid += unwrap(mesh, options).value().report.valid;
  }
  CHECK(valid >= 30);
}
