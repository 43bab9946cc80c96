#include "boundary/contacts.h"

#include <cmath>

#include "base/constants.h"
#include "catch.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Triangles around a corner, from a side of length `first` to one of length 1 that are `gap`
/// apart at the end of the shorter one. The corner has an angle of nearly 2 pi.
PolygonMesh openFan(double first, double gap) {
  constexpr unsigned kRim = 9;
  PolygonMesh mesh;
  mesh.positions = {0, 0, 0};
  const double open = gap / first;
  for (unsigned i = 0; i < kRim; ++i) {
    const double angle = open / 2 + (2 * kPi - open) * i / (kRim - 1), r = i == 0 ? first : 1;
    mesh.positions.insert(mesh.positions.end(), {r * std::cos(angle), r * std::sin(angle), 0});
  }
  mesh.faceOffsets = {0};
  for (unsigned i = 1; i < kRim; ++i) {
    mesh.faceVertices.insert(mesh.faceVertices.end(), {0, i, i + 1});
    mesh.faceOffsets.push_back(3 * i);
  }
  return mesh;
}

/// The chart's own coordinates, turned.
std::vector<double> turned(const DiskChart& chart, double angle) {
  std::vector<double> uv;
  for (const ChartVertex v : chart.vertices()) {
    const double x = chart.positions[3 * v], y = chart.positions[3 * v + 1];
    uv.push_back(x * std::cos(angle) - y * std::sin(angle));
    uv.push_back(x * std::sin(angle) + y * std::cos(angle));
  }
  return uv;
}

}  // namespace

TEST_CASE("parts of an outline touch or do not, however the layout is turned") {
  for (const double first : {1.0, 0.5, 0.03})
    for (int i = 0; i < 40; ++i) {
      const double angle = 0.1571 * i;
      for (const double gap : {0x1p-50, 0x1p-23}) {
        const DiskChart chart = chartOf(openFan(first, gap));
        CAPTURE(first, angle, gap);
        CHECK(findContacts(chart, turned(chart, angle)).count > 0);
      }
      const DiskChart apart = chartOf(openFan(first, 0x1p-16));
      CAPTURE(first, angle);
      CHECK(findContacts(apart, turned(apart, angle)).count == 0);
    }
}
