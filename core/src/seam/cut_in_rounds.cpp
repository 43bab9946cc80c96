#include "seam/cut_in_rounds.h"

#include <utility>

#include "base/stopwatch.h"
#include "hole/fill_holes.h"
#include "seam/cut_round.h"

namespace abflat {

CutInRounds cutInRounds(const SeamMesh& mesh, const BegunSearch& begun, const SeamOptions& options,
                        std::unique_ptr<LogScale> solver, const EliminationRanks& ranks) {
  constexpr int kMostRounds = 40;
  constexpr std::size_t kMuchSmaller = 2;
  CutInRounds out;
  out.seams = begun.seams;
  out.scale.assign(mesh.vertexCount(), 0);
  PartInWork now{&mesh, nullptr, begun.seams, std::move(solver)};
  const bool opensHoles = !mesh.hole.empty() && options.fillHoles == FillHoles::Auto;
  bool isDone = !options.isAuto && !opensHoles;
  while (!isDone && out.steps.rounds < kMostRounds && options.listener.tell()) {
    ++out.steps.rounds;
    CutRound round = cutRound(now, options, begun.given);
    now.seams = std::move(round.seams);
    for (const SurfaceVertex v : round.scale.ids()) out.scale[now.toWhole(v)] = round.scale[v];
    out.steps.slits += round.slits;
    out.steps.splits += round.splits;
    out.steps.solveSeconds += round.solveSeconds;
    const std::size_t changed = round.changedTriangles();
    isDone = changed == 0;
    if (isDone || changed * kMuchSmaller > now.mesh().triangleCount()) continue;
    now.addTo(out.seams);
    Stopwatch watch;
    now = extractPart(now, round.surface, round.isChanged, ranks, options.pool, options.listener);
    out.steps.analysisSeconds += watch.lap();
  }
  now.addTo(out.seams);
  if (!now.part) out.solver = std::move(now.solver);
  if (!mesh.hole.empty())
    openTouchedHoles(mesh, cutAlong(mesh, out.seams, options.listener), options.fillHoles,
                     out.seams);
  return out;
}

}  // namespace abflat
