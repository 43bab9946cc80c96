#include "refine/outline_shape.h"

#include <algorithm>
#include <cmath>

#include "abflat/flatten.h"
#include "abflat/samples.h"
#include "base/constants.h"
#include "boundary/chart_flattener.h"
#include "catch.h"
#include "check/validity.h"
#include "flatten/refine_chart.h"
#include "support/meshes.h"
#include "support/problems.h"
#include "support/refined.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Places on one side of a grid, without its corners.
StraightPlaces oneSide(const DiskChart& chart, std::size_t from, std::size_t length) {
  StraightPlaces out(chart.boundary.size(), 0);
  for (std::size_t i = 1; i < length; ++i) out[BoundaryIndex((from + i) % out.size())] = 1;
  return out;
}

}  // namespace

TEST_CASE("what angles are below their bounds changes as differences say", "[refine]") {
  const DiskChart chart = chartOf(bumpyGrid(5, 4, 0.6, 2));
  std::vector<double> uv = conformalLayout(chart);
  OutlineRules rules;
  rules.bounds.assign(chart.boundary.size(), 1.9);
  rules.bounds[BoundaryIndex(3)] = 2;
  rules.margin = 3;
  const OutlineShape shape(chart, rules);
  REQUIRE(shape.bounds().size() == chart.boundary.size() - 1);
  for (const OutlineShape::Bound& b : shape.bounds()) {
    const OutlineShape::Slack s = shape.slackOf(b, uv);
    CHECK(s.value ==
          Approx(1.9 * kPi - boundaryAngle(chart, uv, chart.boundary[b.place])).margin(1e-12));
    for (std::size_t i = 0; i < 6; ++i) {
      constexpr double kStep = 1e-6;
      std::vector<double> up = uv;
      up[2 * std::size_t{s.contact.vertex[i / 2]} + i % 2] += kStep;
      const double slope = (shape.slackOf(b, up).value - s.value) / kStep;
      CHECK(s.contact.change[i] == Approx(slope).epsilon(1e-3).margin(1e-4));
    }
  }
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(uv.size()));
  SparseEntries hessian;
  shape.addDerivatives(uv, gradient, hessian);
  const double before = shape.energy(uv);
  REQUIRE(before > 0);
  for (std::size_t i = 0; i < uv.size(); ++i) {
    constexpr double kStep = 1e-6;
    uv[i] += kStep;
    const double slope = (shape.energy(uv) - before) / kStep;
    uv[i] -= kStep;
    CHECK(gradient[static_cast<Eigen::Index>(i)] ==
          Approx(slope).epsilon(1e-3).margin(1e-4 * gradient.cwiseAbs().maxCoeff()));
  }
}

TEST_CASE("straight parts lie on lines, wherever they begin along the boundary", "[refine]") {
  const DiskChart chart = chartOf(bumpyGrid(8, 6, 0.6, 4));
  const std::size_t n = chart.boundary.size();
  for (const std::size_t from : {std::size_t{0}, n - 3}) {
    std::vector<double> uv = conformalLayout(chart);
    OutlineRules rules;
    rules.straight = oneSide(chart, from, 6);
    OutlineShape(chart, rules).straighten(uv);
    const std::vector<double> points = boundaryUv(chart, uv);
    const double *a = &points[2 * from], *b = &points[2 * ((from + 6) % n)];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    for (std::size_t i = 1; i < 6; ++i) {
      const double* x = &points[2 * ((from + i) % n)];
      const double off = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
      CHECK(std::abs(off) <= 1e-14 * length * length);
    }
  }
}

TEST_CASE("an outline that bounds hold finds its form in few steps", "[refine]") {
  for (const char* name : {"head", "three-balls"}) {
    const auto sample = std::find_if(samples().begin(), samples().end(),
                                     [&](const Sample& s) { return s.name == name; });
    const DiskChart chart = chartOf(sample->make(1));
    ThreadPool pool(1);
    SolverOptions solver;
    solver.pool = &pool;
    ChartFlattener flattener(chart, solver);
    RefineConstraints constraints;
    constraints.bounds.assign(chart.boundary.size(), 1);
    constraints.balance = 1;
    constraints.pool = &pool;
    FlattenOptions options;
    options.t = 1;
    Attempt attempt = flattenChart(flattener, outlineGoal(options, constraints.bounds));
    REQUIRE(attempt.valid());
    refineChart(flattener, constraints, attempt);
    REQUIRE(attempt.refined);
    CAPTURE(name, attempt.refined->steps);
    CHECK(attempt.refined->limit == "boundary angles reach their bounds");
    CHECK(attempt.refined->steps <= 10);
  }
}

TEST_CASE("a refined outline keeps its bounds and straight parts", "[refine]") {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const DiskChart chart = chartOf(bumpyGrid(10 + seed, 9, 0.9, seed));
    for (const double t : {1.0, 1.1, 2.0}) {
      ThreadPool pool(1);
      SolverOptions solver;
      solver.pool = &pool;
      const bool isStraight = seed % 2 == 1 || t == 2;
      ChartFlattener flattener(
          chart, solver, {false, {}, isStraight ? oneSide(chart, seed, 7) : StraightPlaces()});
      FlattenOptions options;
      options.t = t;
      const BoundaryBounds bounds(chart.boundary.size(), t);
      Attempt attempt = flattenChart(flattener, outlineGoal(options, bounds));
      REQUIRE(attempt.valid());
      const Attempt before = attempt;
      RefineConstraints constraints;
      constraints.balance = 0.5;
      constraints.bounds = bounds;
      constraints.pool = &pool;
      refineChart(flattener, constraints, attempt);
      REQUIRE(attempt.refined);
      CAPTURE(seed, t, attempt.refined->steps, attempt.refined->limit);
      CHECK(attempt.valid());
      CHECK(exceededBounds(chart, attempt.uv, bounds).count == 0);
      if (attempt.straight) CHECK(attempt.straight->deviation < 1e-9);
      // With the outline held in place, less is gained.
      RefineOptions held = withBalance(0.5);
      held.isFixed.assign(chart.vertexCount(), 0);
      for (const ChartCorner h : chart.boundary) held.isFixed[chart.vertexOfCorner[h]] = 1;
      CHECK(attempt.refined->energy < refine(chart, before.uv, held).energy);
      CHECK(attempt.refined->limit.find("keeps its shape") == std::string::npos);
    }
  }
}
