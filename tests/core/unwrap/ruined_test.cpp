#include <algorithm>
#include <cmath>

#include "abflat/unwrap.h"
#include "base/constants.h"
#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A dome of rings around a pole. Each ring has a vertex in the middle of each edge, a hair off it,
/// as closing T-junctions leaves them.
PolygonMesh domeWithSlivers(unsigned n, unsigned rings, double hair) {
  PolygonMesh mesh;
  const auto vertex = [&](double lat, double lon, double off) {
    const double r = std::cos(lat) * (1 - off);
    mesh.positions.insert(mesh.positions.end(),
                          {r * std::cos(lon), r * std::sin(lon), std::sin(lat) * (1 - off)});
    return static_cast<std::uint32_t>(mesh.vertexCount() - 1);
  };
  mesh.faceOffsets = {0};
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.faceVertices.insert(mesh.faceVertices.end(), {a, b, c});
    mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
  };
  std::vector<std::uint32_t> below, middle;
  for (unsigned k = 0; k <= rings; ++k) {
    const double lat = 0.45 * kPi * k / (rings + 1);
    std::vector<std::uint32_t> ring;
    for (unsigned i = 0; i < n; ++i) ring.push_back(vertex(lat, 2 * kPi * i / n, 0));
    for (unsigned i = 0; k > 0 && i < n; ++i) {
      const unsigned j = (i + 1) % n;
      face(below[i], below[j], ring[i]);
      face(below[j], ring[j], ring[i]);
      const double* a = &mesh.positions[3 * std::size_t{ring[i]}];
      const double* b = &mesh.positions[3 * std::size_t{ring[j]}];
      const double at[] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 + hair};
      mesh.positions.insert(mesh.positions.end(), at, at + 3);
      const auto between = static_cast<std::uint32_t>(mesh.vertexCount() - 1);
      if (k < rings) continue;
      face(ring[i], ring[j], between);
      middle.insert(middle.end(), {ring[i], between, ring[j]});
    }
    below = ring;
  }
  const std::uint32_t pole = vertex(kPi / 2, 0, 0);
  for (std::size_t i = 0; i < middle.size(); i += 3) {
    face(middle[i], middle[i + 1], pole);
    face(middle[i + 1], middle[i + 2], pole);
  }
  return mesh;
}

}  // namespace

TEST_CASE("slivers do not ruin charts, however thin they are", "[unwrap]") {
  for (const double hair : {1e-3, 1e-5, 1e-6, 1e-7, 1e-8})
    for (const unsigned n : {5u, 12u, 30u}) {
      UnwrapOptions options;
      options.precision = Precision::Single;
      const Result<UnwrapResult> r = unwrap(domeWithSlivers(n, 4, hair), options);
      CAPTURE(hair, n);
      REQUIRE(r.ok());
      CHECK(r.value().report.valid);
      for (const UnwrapChart& chart : r.value().report.charts)
        CHECK(chart.symmetricDirichlet <= 1 + 10 * (options.maxStretch - 1));
    }
}

TEST_CASE("a chart that is stretched too much is named by a face", "[unwrap]") {
  UnwrapOptions options;
  options.t = 1;
  const Result<UnwrapResult> r = unwrap(uvSphere(16, 8), options);
  REQUIRE(r.ok());
  const auto& notes = r.value().report.notes;
  const bool isStretched =
      std::any_of(r.value().report.charts.begin(), r.value().report.charts.end(),
                  [&](const UnwrapChart& c) { return c.symmetricDirichlet > options.maxStretch; });
  REQUIRE(isStretched);
  CHECK(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find("for the chart of face") != std::string::npos;
  }));
}
