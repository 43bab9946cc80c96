// Refining for lengths beside solving for angles: medians of repeated runs on one thread, each
// followed by one on two, and the energy that a long run to convergence reaches. One line of JSON.
//
//   abflat_refine_bench WHAT BALANCE REPEAT    WHAT: see bench::makeMesh
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "abflat/flatten.h"
#include "bench_matrices.h"
#include "flatten/flatten_chart.h"
#include "refine/refine.h"

using namespace abflat;

namespace {

constexpr int kReferenceSteps = 400;
constexpr double kReferenceTolerance = 1e-12;

bool runOnce(const PolygonMesh& mesh, double balance, int threads, FlattenResult& out) {
  FlattenOptions options;
  options.balance = balance;
  options.threads = threads;
  Result<FlattenResult> flat = flatten(mesh, options);
  if (!flat.ok()) std::fprintf(stderr, "%s\n", flat.status().message.c_str());
  out = std::move(flat.value());
  return flat.ok();
}

double medianOf(const std::vector<FlattenResult>& runs, double Timings::*stage) {
  std::vector<double> values;
  for (const FlattenResult& run : runs) values.push_back(run.report.timings.*stage);
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// From the same angles with as many steps as it takes.
Refinement reference(const PolygonMesh& mesh, double balance) {
  const DiskChart chart = makeDiskChart(mesh, buildSurface(mesh));
  ThreadPool pool(0);
  SolverOptions solver;
  solver.pool = &pool;
  ChartFlattener flattener(chart, solver);
  const Attempt start =
      flattenChart(flattener, automaticGoal(BoundaryBounds(chart.boundary.size(), 2)));
  flattener.endSolving();
  RefineOptions options;
  options.energy = Energy(balance);
  options.maxSteps = kReferenceSteps;
  options.tolerance = kReferenceTolerance;
  options.pool = &pool;
  return refine(chart, start.uv, options);
}

bool run(const std::string& what, double balance, int repeat) {
  PolygonMesh mesh;
  if (!bench::makeMesh(what, mesh)) return false;
  std::vector<FlattenResult> one(static_cast<std::size_t>(std::max(1, repeat))), two(one.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    if (!runOnce(mesh, balance, 1, one[i]) || !runOnce(mesh, balance, 2, two[i])) return false;
  const ChartReport& chart = one.front().report.charts.front();
  if (!chart.refined) {
    std::fprintf(stderr, "%s: nothing is refined\n", what.c_str());
    return false;
  }
  const Refinement least = reference(mesh, balance);
  std::printf("{\"faces\": %zu, \"balance\": %g, \"repeat\": %zu", chart.faces, balance,
              one.size());
  std::printf(", \"solve\": %.6g, \"refine\": %.6g", medianOf(one, &Timings::solve),
              medianOf(one, &Timings::refine));
  if (two.back().report.threads == 2)
    std::printf(", \"solveOnTwo\": %.6g, \"refineOnTwo\": %.6g", medianOf(two, &Timings::solve),
                medianOf(two, &Timings::refine));
  std::printf(", \"identical\": %s", one.back().uv == two.back().uv ? "true" : "false");
  std::printf(", \"steps\": %d, \"energyBefore\": %.9g, \"energy\": %.9g", chart.refined->steps,
              chart.refined->energyBefore, chart.refined->energy);
  std::printf(", \"referenceSteps\": %d, \"reference\": %.9g, \"isConverged\": %s", least.steps,
              least.energy, least.isConverged ? "true" : "false");
  std::printf(", \"valid\": %s, \"limit\": \"%s\"}\n", one.back().report.valid ? "true" : "false",
              chart.refined->limit.c_str());
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4) return run(argv[1], std::atof(argv[2]), std::atoi(argv[3])) ? 0 : 1;
  std::fputs("usage: abflat_refine_bench WHAT BALANCE REPEAT\n", stderr);
  return 2;
}
