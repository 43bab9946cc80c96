#include "seam/shorten_seams.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "catch.h"
#include "seam/log_scale.h"
#include "seam/prediction.h"
#include "seam/seam_tips.h"
#include "support/copies.h"
#include "support/cut_meshes.h"
#include "support/isosurface.h"
#include "support/meshes.h"
#include "support/squares.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A plane with a round hill, and a slit from the border over its top and far beyond; beside it, if
/// wanted, a larger plane without any seam.
struct Hill {
  static constexpr unsigned kSide = 41;
  Cuttable c;
  Seams seams = Seams(c.seamMesh.twin.size(), 0);

  explicit Hill(bool hasPlane = false) : c(meshOf(hasPlane), SeamCosts::Length) {
    for (const SurfaceCorner h : seams.ids())
      if (isOnSlit(c.seamMesh.tail(h)) && isOnSlit(c.seamMesh.head(h))) seams[h] = 1;
  }

  /// The slit's column goes through the top, which is in row 12.
  bool isOnSlit(SurfaceVertex v) const {
    const double *p = &c.seamMesh.positions[3 * v], *first = c.seamMesh.positions.data();
    const double unit = (c.seamMesh.positions[3 * (kSide * kSide - 1)] - first[0]) / (kSide - 1);
    const auto column = std::lround((p[0] - first[0]) / unit);
    const auto row = std::lround((p[1] - first[1]) / unit);
    return column == 20 && row <= 34;
  }
  static PolygonMesh meshOf(bool hasPlane) {
    PolygonMesh out = makeTriangleMesh(positions(), triangles());
    const PolygonMesh plane = squares(60, 60, [](auto, auto) { return true; });
    if (hasPlane) test::append(out, transformed(plane, 1, {100, 0, 0}));
    return out;
  }
  static std::vector<double> positions() {
    std::vector<double> out;
    for (unsigned j = 0; j < kSide; ++j)
      for (unsigned i = 0; i < kSide; ++i) {
        const double x = (i - 20.0) / 6, y = (j - 12.0) / 6;
        out.insert(out.end(), {1.0 * i, 1.0 * j, 14 * std::exp(-x * x - y * y)});
      }
    return out;
  }
  static std::vector<std::uint32_t> triangles() {
    std::vector<std::uint32_t> out;
    for (unsigned j = 0; j + 1 < kSide; ++j)
      for (unsigned i = 0; i + 1 < kSide; ++i) {
        const std::uint32_t a = j * kSide + i;
        out.insert(out.end(), {a, a + 1, a + kSide + 1, a, a + kSide + 1, a + kSide});
      }
    return out;
  }
};

double lengthOf(const SeamMesh& mesh, const Seams& seams) {
  double out = 0;
  for (const SurfaceCorner h : seams.ids())
    if (seams[h]) out += mesh.length[h] / 2;
  return out;
}

double stretchOf(const SeamMesh& mesh, const Seams& seams) {
  const CutSurface s = cutAlong(mesh, seams);
  return predictStretch(mesh, s, LogScale(mesh, nullptr).solve(s, {})).stretch.front();
}

Seams shortened(const Hill& hill, double maxStretch,
                const SeamPrices& prices = SeamPrices::none()) {
  SeamOptions options;
  options.maxStretch = maxStretch;
  options.prices = prices;
  Seams out = hill.seams;
  LogScales u;
  LogScale scale(hill.c.seamMesh, nullptr);
  const Seams kept(out.size(), 0);
  shortenSeams({hill.c.seamMesh, kept, options, scale, u, out});
  return out;
}

}  // namespace

TEST_CASE("what taking a seam back costs is told within a factor of two", "[seams]") {
  const Hill hill;
  const SeamMesh& mesh = hill.c.seamMesh;
  LogScale scale(mesh, nullptr);
  const Seams kept(hill.seams.size(), 0);
  Seams seams = hill.seams;
  // Beyond the top nothing depends on the slit; towards it, more and more does.
  for (int row = 34; row > 16; row -= 3) {
    const CutSurface s = cutAlong(mesh, seams);
    const LogScales u = scale.solve(s, {});
    const Prediction p = predictStretch(mesh, s, u);
    const std::vector<SeamTip> tips =
        findTips({mesh, seams, kept, u, outgoingHalfEdges(mesh)}, s, p, {1}, scale);
    REQUIRE(tips.size() == 1);
    REQUIRE(tips[0].edges.size() == static_cast<std::size_t>(row));
    for (std::size_t i = 0; i < 3; ++i) {
      const SurfaceCorner h = tips[0].edges[i];
      seams[h] = seams[mesh.twin[h]] = 0;
    }
    const double change = stretchOf(mesh, seams) - p.stretch.front();
    CAPTURE(row, change, tips[0].stretch[2]);
    CHECK(tips[0].stretch[2] >= 0);
    if (change > 1e-3) {
      CHECK(tips[0].stretch[2] < 2 * change);
      CHECK(tips[0].stretch[2] > change / 2);
    }
  }
}

TEST_CASE("seams are taken back alike beside a larger chart that is done", "[seams]") {
  const Hill alone, beside(true);
  const double least = stretchOf(alone.c.seamMesh, alone.seams);
  for (const double more : {1.01, 1.02, 1.035}) {
    const Seams a = shortened(alone, more * least), b = shortened(beside, more * least);
    const auto count = [](const Seams& seams) { return std::count(seams.begin(), seams.end(), 1); };
    CHECK(count(a) < count(alone.seams));
    CHECK(count(a) == count(b));
    CHECK(std::equal(a.begin(), a.end(), b.begin()));
  }
}

TEST_CASE("seams are taken back as far as the bound allows", "[seams]") {
  const Hill hill;
  const SeamMesh& mesh = hill.c.seamMesh;
  const double least = stretchOf(mesh, hill.seams);
  double before = lengthOf(mesh, hill.seams);
  for (const double more : {1.02, 1.035, 1.05}) {
    const double bound = least * more;
    const Seams seams = shortened(hill, bound);
    CAPTURE(least, bound);
    for (const SurfaceCorner h : seams.ids()) CHECK((!seams[h] || hill.seams[h]));
    const double stretch = stretchOf(mesh, seams), length = lengthOf(mesh, seams);
    CHECK(stretch <= bound);
    CHECK(stretch - 1 > 0.6 * (bound - 1));
    CHECK(length < before);
    before = length;
  }
  CHECK(lengthOf(mesh, shortened(hill, 2)) == 0);
}

TEST_CASE("what stretch costs more than a seam is worth is not taken back", "[seams]") {
  const Hill hill;
  const SeamMesh& mesh = hill.c.seamMesh;
  const double bound = 2;
  double before = lengthOf(mesh, shortened(hill, bound));
  for (const double price : {2.0, 20.0, 200.0}) {
    SeamPrices prices = SeamPrices::none();
    prices.stretch = price;
    const Seams seams = shortened(hill, bound, prices);
    CAPTURE(price);
    CHECK(lengthOf(mesh, seams) >= before);
    before = lengthOf(mesh, seams);
    // No more than it costs.
    const double gained = lengthOf(mesh, hill.seams) - before;
    const double more = stretchOf(mesh, seams) - stretchOf(mesh, hill.seams);
    CHECK(price * more * std::sqrt(mesh.totalArea()) <= gained * 1.01);
  }
  CHECK(before > 0);
}

TEST_CASE("where there is no room seams stay as they are", "[seams]") {
  const Hill hill;
  CHECK(shortened(hill, 1.0001) == hill.seams);
}

TEST_CASE("seams that are given are not shortened", "[seams]") {
  const Hill hill;
  SeamOptions options;
  options.maxStretch = 100;
  Seams seams = hill.seams;
  LogScales u;
  LogScale scale(hill.c.seamMesh, nullptr);
  shortenSeams({hill.c.seamMesh, hill.seams, options, scale, u, seams});
  CHECK(seams == hill.seams);
}

TEST_CASE("the more stretch is allowed the shorter are seams; charts are disks", "[seams]") {
  const Cuttable c(isosurface(24, rings(1)));
  double before = 1e9;
  for (const double maxStretch : {1.01, 1.05, 1.3, 3.0}) {
    SeamOptions options;
    options.maxStretch = maxStretch;
    SeamReport report;
    const Seams seams = findSeams(c.seamMesh, {}, options, &report);
    CHECK(report.seamLength <= before);
    before = report.seamLength;
    for (const SurfaceCorner h : seams.ids()) CHECK((!seams[h] || report.found[h]));
    for (const PolygonMesh& chart : chartsOf(c, seams)) CHECK(inspect(chart).disk.ok());
  }
}
