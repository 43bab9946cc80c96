// Disks with long folded boundaries, whose parts would overlap at the energy minimum.
#include <cmath>

#include "base/constants.h"
#include "catch.h"
#include "check/validity.h"
#include "support/instrumented.h"
#include "support/meshes.h"
#include "support/problems.h"
#include "support/refined.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Squares in columns and rows, with a slit every `period` columns, starting at some row.
class SlitGrid {
 public:
  SlitGrid(unsigned columns, unsigned rows, unsigned firstSlitRow, unsigned period)
      : columns_(columns), rows_(rows), first_(firstSlitRow), period_(period) {
    left_.assign((columns + 1) * (rows + 1), 0);
    right_ = left_;
    for (unsigned j = 0; j <= rows; ++j)
      for (unsigned i = 0; i <= columns; ++i) {
        left_[at(i, j)] = right_[at(i, j)] = count_++;
        if (i > 0 && i < columns && i % period_ == 0 && j > first_) right_[at(i, j)] = count_++;
      }
  }

  /// place(i, j) -> x, y, z
  template <class Place>
  PolygonMesh mesh(const Place& place) const {
    PolygonMesh out;
    out.positions.resize(3 * std::size_t{count_});
    out.faceOffsets = {0};
    for (unsigned j = 0; j <= rows_; ++j)
      for (unsigned i = 0; i <= columns_; ++i) {
        const std::array<double, 3> p = place(i, j);
        for (const unsigned v : {left_[at(i, j)], right_[at(i, j)]})
          std::copy(p.begin(), p.end(), &out.positions[3 * std::size_t{v}]);
      }
    for (unsigned j = 0; j < rows_; ++j)
      for (unsigned i = 0; i < columns_; ++i) {
        for (const unsigned v :
             {right_[at(i, j)], left_[at(i + 1, j)], left_[at(i + 1, j + 1)], right_[at(i, j + 1)]})
          out.faceVertices.push_back(v);
        out.faceOffsets.push_back(static_cast<std::uint32_t>(out.faceVertices.size()));
      }
    return out;
  }

 private:
  std::size_t at(unsigned i, unsigned j) const { return i + (columns_ + 1) * std::size_t{j}; }

  unsigned columns_, rows_, first_, period_, count_ = 0;
  /// Vertex of each place, as seen by the faces on its left and on its right.
  std::vector<unsigned> left_, right_;
};

/// Teeth that bulge more the farther they are from the back. Flattened, they are wider than the
/// gaps.
PolygonMesh comb(unsigned teeth, double bulge) {
  constexpr unsigned kColumns = 6, kRows = 24, kBack = 3;
  return SlitGrid(teeth * kColumns, kRows, kBack, kColumns)
      .mesh([&](unsigned i, unsigned j) -> std::array<double, 3> {
        const double x = static_cast<double>(i) / kColumns;
        const double rise = j > kBack ? bulge * (j - kBack) / (kRows - kBack) : 0;
        return {x, j / 6.0, rise * std::abs(std::sin(kPi * x))};
      });
}

/// Arms around a hole on a ruffled surface. They make up more than a full turn, so its two ends
/// would overlap.
PolygonMesh octopus(unsigned arms, double ruffle) {
  constexpr unsigned kColumns = 5, kRows = 16, kBody = 5;
  const unsigned columns = arms * kColumns;
  return SlitGrid(columns, kRows, kBody, kColumns)
      .mesh([&](unsigned i, unsigned j) -> std::array<double, 3> {
        const double turn = 2 * kPi * 0.98 * i / columns, r = 0.3 + 0.7 * j / kRows;
        return {r * std::cos(turn), -r * std::sin(turn), ruffle * r * r * std::cos(arms * turn)};
      });
}

void checkHeldApart(const PolygonMesh& mesh, int mostSteps = 25) {
  const DiskChart chart = chartOf(mesh);
  const std::vector<double> uv = conformalLayout(chart);
  for (const double balance : {0.25, 0.5, 1.0}) {
    const Refinement r = refine(chart, uv, withBalance(balance));
    CAPTURE(chart.triangleCount(), balance, r.steps, r.energyBefore, r.energy);
    CHECK(r.isHeldApart);
    CHECK(r.isConverged);
    CHECK(r.steps <= mostSteps);
    CHECK(r.energy < r.energyBefore);
    CHECK(checkSeparated(chart, r.uv).valid());
  }
}

}  // namespace

TEST_CASE("teeth of a comb that would lie on each other are held apart", "[refine]") {
  for (const double bulge : {0.2, 0.4}) checkHeldApart(comb(cases(9u, 4u), bulge));
}

TEST_CASE("the ends of a ring that would lie on each other are held apart", "[refine]") {
  for (const double ruffle : {0.1, 0.2}) checkHeldApart(octopus(cases(8u, 5u), ruffle));
}

TEST_CASE("a crowd of teeth that would lie on each other is held apart", "[refine]") {
  const unsigned n = cases(50u, 30u);
  checkHeldApart(uvSphere(n, n - 1), 60);
}
