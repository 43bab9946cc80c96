#include "islands/judge_faces.h"

#include "abflat/generated/names.h"
#include "abflat/generated/pack_report.h"
#include "catch.h"

using namespace abflat;

namespace {

constexpr std::uint8_t bit(UvFault fault) { return static_cast<std::uint8_t>(fault); }

/// A triangle whose right angle is at a point.
void add(PlacedTriangles& out, double u, double v, double width, double height) {
  out.uv.insert(out.uv.end(), {u, v, u + width, v, u, v + height});
  out.face.push_back(static_cast<std::uint32_t>(out.face.size()));
  out.stack.push_back(0);
}

}  // namespace

TEST_CASE("judge faces: each fault is found where it is") {
  PlacedTriangles placed;
  add(placed, 0.1, 0.1, 0.2, 0.2);
  add(placed, 0.5, 0.5, 0.2, -0.2);
  add(placed, 0.7, 0.7, 0.2, 0);
  add(placed, 0.9, 0.1, 0.2, 0.2);
  add(placed, 0.25, 0.1, 0.2, 0.2);
  const std::uint8_t overlapping = bit(UvFault::Overlapping);
  CHECK(faultsOf(placed, 1) == std::vector<std::uint8_t>{overlapping, bit(UvFault::Flipped),
                                                         bit(UvFault::Empty), bit(UvFault::Outside),
                                                         overlapping});
}

TEST_CASE("judge faces: within one of several tiles, not across their border") {
  PlacedTriangles placed;
  add(placed, 1.1, 0.1, 0.2, 0.2);
  add(placed, 0.9, 0.5, 0.2, 0.2);
  CHECK(faultsOf(placed, 1) ==
        std::vector<std::uint8_t>{bit(UvFault::Outside), bit(UvFault::Outside)});
  CHECK(faultsOf(placed, 2) == std::vector<std::uint8_t>{0, bit(UvFault::Outside)});
}

TEST_CASE("judge faces: a face counts once for each fault that any of its triangles has") {
  PlacedTriangles placed;
  for (int i = 0; i < 4; ++i) add(placed, 0.1, 0.4, 0.2, i == 3 ? -0.2 : 0.2);
  add(placed, 0.1, 0.3, 0.2, 0.2);
  placed.face = {3, 3, 5, 5, 7};
  PackReport report;
  countFaults(placed.face, faultsOf(placed, 1), report);
  CHECK(report.facesOverlapping == 3);
  CHECK(report.facesFlipped == 1);
  CHECK(report.facesEmpty == 0);
  CHECK(report.facesOutside == 0);
}
