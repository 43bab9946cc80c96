// Closed surfaces of many kinds, with balances from angles to lengths.
#include <algorithm>

#include "abflat/unwrap.h"
#include "catch.h"
#include "support/closed_meshes.h"
#include "support/instrumented.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

bool tellsOfStretch(const UnwrapReport& report) {
  return std::any_of(report.notes.begin(), report.notes.end(), [](const std::string& note) {
    return note.find("stretched by more") != std::string::npos;
  });
}

void checkCharts(const UnwrapReport& report, double balance) {
  double most = 0;
  for (const UnwrapChart& chart : report.charts) {
    CHECK(chart.valid);
    CHECK(chart.problem.empty());
    most = std::max(most, chart.symmetricDirichlet);
    if (!chart.refined) continue;
    CHECK(balance > 0);
    CHECK(chart.refined->energy <= chart.refined->energyBefore);
    CHECK(chart.refined->energy >= 1 - 1e-12);
  }
  CHECK((most > report.options.maxStretch) == tellsOfStretch(report));
}

void checkClosedMeshes(unsigned begin, unsigned end) {
  for (unsigned number = begin; number < end; ++number) {
    const ClosedMesh closed = closedMesh(number);
    for (const double balance : {0.0, 0.25, 0.5, 1.0}) {
      UnwrapOptions options;
      options.balance = balance;
      INFO(closed.family << " " << number << ", balance " << balance);
      const UnwrapReport report = unwrapped(closed.mesh, options).report;
      CHECK(report.input.boundaryLoops == 0);
      CHECK(report.input.nonManifoldEdges == 0);
      CHECK(report.input.orientationConflicts == 0);
      if (closed.genus >= 0) CHECK(report.input.genus == closed.genus);
      checkCharts(report, balance);
    }
  }
}

constexpr unsigned kUsualMeshes = 50;

}  // namespace

TEST_CASE("closed surfaces of many kinds are valid at any balance", "[balance][quality]") {
  checkClosedMeshes(0, cases(kUsualMeshes, kClosedFamilies));
}

TEST_CASE("more closed surfaces are valid at any balance", "[balance][.long]") {
  checkClosedMeshes(kUsualMeshes, 100);
}
