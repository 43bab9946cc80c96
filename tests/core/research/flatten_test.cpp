#include "abflat/flatten.h"

#include <cmath>

#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

TEST_CASE("every iterative solver and formulation gives the same layout and is reported") {
  const PolygonMesh mesh = bumpyGrid(8, 7, 0.3, 5);
  FlattenOptions options;
  options.t = 1;
  const Result<FlattenResult> wanted = flatten(mesh, options);
  REQUIRE(wanted.ok());
  for (const LinearSolver solver :
       {LinearSolver::Minres, LinearSolver::Symmlq, LinearSolver::Gmres, LinearSolver::Bicgstab})
    for (const Formulation formulation : {Formulation::Log, Formulation::Product}) {
      options.linearSolver = solver;
      options.formulation = formulation;
      const Result<FlattenResult> r = flatten(mesh, options);
      REQUIRE(r.ok());
      const ChartReport& chart = r.value().report.charts.front();
      CHECK(chart.valid);
      CHECK(chart.linearSolver == solver);
      CHECK(chart.formulation == formulation);
      CHECK(chart.history.front().linearIterations > 0);
      for (std::size_t i = 0; i < wanted.value().uv.size(); ++i)
        CHECK(std::abs(r.value().uv[i] - wanted.value().uv[i]) < 1e-6);
    }
}
