#include "draw/kkt_pattern.h"

#include "abflat/mesh.h"
#include "boundary/requested_bounds.h"
#include "chart/disk_chart.h"
#include "mesh/surface.h"
#include "research/kkt_system.h"
#include "solve/angle_solver.h"

namespace abflat {
namespace {

constexpr std::uint32_t kDropped = 0xffffffffu;

/// Row in the paper's order of each row of KktSystem, and the blocks.
std::vector<std::uint32_t> paperOrder(const AngleProblem& problem, const ConstraintRows& rows,
                                      const std::vector<std::uint8_t>& active,
                                      std::vector<KktBlock>& blocks) {
  const std::size_t corners = problem.vertexOfCorner.size(), triangles = corners / 3;
  std::vector<std::uint32_t> out(corners + triangles + rows.count(), kDropped);
  std::uint32_t next = 0;
  const auto startBlock = [&](const char* name) {
    if (!blocks.empty()) blocks.back().end = next;
    blocks.push_back({name, next, next});
  };
  const auto addRows = [&](bool isOnBoundary, std::uint32_t offset) {
    for (const ChartVertex v : problem.vertices()) {
      if ((problem.isBoundary[v] != 0) != isOnBoundary || (isOnBoundary && !active[v])) continue;
      out[corners + triangles + rows.ofVertex[v] + offset] = next++;
    }
  };
  startBlock("Hessian");
  while (next < corners) out[next] = next, ++next;
  startBlock("triangles");
  while (next < corners + triangles) out[next] = next, ++next;
  startBlock("vertices");
  addRows(false, 0);
  startBlock("wheels");
  addRows(false, 1);
  startBlock("active bounds");
  addRows(true, 0);
  blocks.back().end = next;
  return out;
}

KktPattern patternOf(const AngleProblem& problem, const AngleSolution& s, Formulation formulation) {
  const ConstraintRows rows = numberRows(problem);
  Linearization lin;
  linearize(problem, rows, {s.angles, s.multipliers.row, Curvature::Exact}, lin);
  const NewtonPoint at{problem, s.angles, s.multipliers, lin, s.active, s.activeEdge};
  const Eigen::SparseMatrix<double> matrix = buildKkt(at, rows, formulation).matrix;
  KktPattern out;
  const std::vector<std::uint32_t> place = paperOrder(problem, rows, s.active, out.blocks);
  out.size = out.blocks.back().end;
  const std::size_t corners = problem.vertexOfCorner.size();
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, column); it; ++it) {
      const auto r = static_cast<std::size_t>(it.row()), c = static_cast<std::size_t>(column);
      if (place[r] == kDropped || place[c] == kDropped) continue;
      out.entries.push_back({place[r], place[c]});
      if (r < corners && c < corners) ++out.hessianEntries;
    }
  return out;
}

}  // namespace

Result<KktPattern> kktPattern(const PolygonMesh& mesh, double t, Formulation formulation) {
  if (Status s = validateArrays(mesh); !s.ok()) return s;
  const Surface surface = buildSurface(mesh);
  if (!surface.summary.disk.ok()) return surface.summary.disk;
  const DiskChart chart = makeDiskChart(mesh, surface);
  FlattenOptions options;
  options.t = t;
  const Result<BoundaryBounds> bounds = requestedBounds(chart, options, {});
  if (!bounds.ok()) return bounds.status();
  AngleProblem problem = buildAngleProblem(chart);
  setBounds(problem, chart, bounds.value());
  return patternOf(problem, AngleSolver(problem, {}).solve(nullptr), formulation);
}

}  // namespace abflat
