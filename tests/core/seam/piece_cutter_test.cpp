#include "seam/piece_cutter.h"

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "hole/fill_holes.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"
#include "support/squares.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A planar mesh, laid out where it is.
struct Flat {
  Cuttable cuttable;
  CutSurface surface;
  IdVector<OpenVertex, PlanePoint> at;

  explicit Flat(const PolygonMesh& mesh, bool isFilled = false) : cuttable(mesh) {
    if (isFilled) fillHoles(FillHoles::Auto, {}, cuttable.seamMesh);
    const SeamMesh& m = cuttable.seamMesh;
    surface = cutAlong(m, Seams(m.twin.size(), 0));
    for (const SurfaceVertex v : surface.meshVertex)
      at.push_back({m.positions[3 * v], m.positions[3 * v + 1]});
  }

  BoundaryIndex pointAt(const Piece& piece, double x, double y) const {
    const auto off = [&](OpenVertex v) { return std::hypot(at[v].x - x, at[v].y - y); };
    return BoundaryIndex(
        std::min_element(piece.loop.begin(), piece.loop.end(),
                         [&](OpenVertex a, OpenVertex b) { return off(a) < off(b); }) -
        piece.loop.begin());
  }

  double areaOfLoop(const Piece& piece) const {
    double sum = 0;
    for (const BoundaryIndex i : piece.loop.ids()) {
      const PlanePoint a = at[piece.loop[i]];
      const PlanePoint b = at[piece.loop[nextAlong(i, piece.loop.size())]];
      sum += a.x * b.y - a.y * b.x;
    }
    return sum / 2;
  }
};

bool always(std::uint32_t, std::uint32_t) { return true; }

}  // namespace

TEST_CASE("pieces are bounded by their loops, and all of the surface is theirs", "[room]") {
  const Flat flat(squares(20, 6, always));
  PieceCutter cutter(flat.cuttable.seamMesh, flat.surface, flat.at);
  const double all = cutter.pieces().front().flatArea;
  const double low = 0, high = flat.at[flat.surface.vertexOfCorner.front()].y + 1;
  for (const double x : {0.25, 0.6, 0.4}) {
    for (const PieceId p : cutter.pieces().ids()) {
      const Piece piece = cutter.pieces()[p];
      const BoundaryIndex from = flat.pointAt(piece, x, low), to = flat.pointAt(piece, x, high);
      if (std::abs(flat.at[piece.loop[from]].x - x) > 0.03) continue;
      REQUIRE(cutter.split(p, std::min(from, to), std::max(from, to), 0.01));
      break;
    }
  }
  REQUIRE(cutter.pieces().size() == 4);
  double sum = 0;
  for (const Piece& piece : cutter.pieces()) {
    CHECK(piece.flatArea == Approx(flat.areaOfLoop(piece)));
    CHECK(piece.flatArea > 0.1 * all);
    sum += piece.flatArea;
  }
  CHECK(sum == Approx(all));
  // Straight across, three times.
  CHECK(cutter.cuts().size() == 3 * 6);
  const SeamMesh& mesh = flat.cuttable.seamMesh;
  const double side = std::sqrt(mesh.totalArea() / (20 * 6));
  CHECK(cutter.length() == Approx(3 * 6 * side));
}

TEST_CASE("a cut through a filled hole leaves its rim to both sides", "[room]") {
  const Flat flat(squares(18, 18,
                          [](std::uint32_t i, std::uint32_t j) {
                            return i < 6 || i >= 12 || j < 6 || j >= 12;
                          }),
                  true);
  PieceCutter cutter(flat.cuttable.seamMesh, flat.surface, flat.at);
  REQUIRE(cutter.pieces().size() == 1);
  const Piece whole = cutter.pieces().front();
  CHECK(flat.areaOfLoop(whole) == Approx(whole.flatArea * 9 / 8));
  const double middle = flat.at[whole.loop[flat.pointAt(whole, 9.0, 9.0)]].x / 2;
  REQUIRE(cutter.split(PieceId(0), flat.pointAt(whole, middle, 0), flat.pointAt(whole, middle, 9.0),
                       0.01));
  REQUIRE(cutter.pieces().size() == 2);
  for (const Piece& piece : cutter.pieces())
    CHECK(piece.flatArea == Approx(flat.areaOfLoop(piece)));
  // The second cut ends at the rim.
  for (const PieceId p : IdRange<PieceId>(2)) {
    const Piece half = cutter.pieces()[p];
    double mean = 0;
    for (const OpenVertex v : half.loop)
      mean += flat.at[v].x / static_cast<double>(half.loop.size());
    const double outer = mean < middle ? 0 : 2 * middle;
    const double rim = (2 * middle + outer) / 3;
    REQUIRE(
        cutter.split(p, flat.pointAt(half, outer, middle), flat.pointAt(half, rim, middle), 0.01));
  }
  double sum = 0;
  for (const Piece& piece : cutter.pieces()) {
    CHECK(piece.flatArea == Approx(flat.areaOfLoop(piece)));
    sum += piece.flatArea;
  }
  CHECK(sum == Approx(whole.flatArea));
}
