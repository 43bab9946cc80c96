#include "unwrap/stacks.h"

#include <numeric>
#include <utility>

#include "unwrap/spread.h"

namespace abflat {

/// Charts of an earlier run that keep their places stay as they are.
bool Stacks::mayStack() const {
  return options_.stack != Stack::None && !options_.reuse.keepsPlaces;
}

void Stacks::leaveOutComponents(const UncutParts& parts) {
  if (!mayStack()) return;
  const CornerMatch found =
      alikeComponents({input_, welded_, parts.surface}, parts.given, parts.fixed, options_, unfit_);
  if (found.empty()) return;
  const KeptTriangles kept(areModels(parts.surface, found));
  parts.breaks = kept.ofCorners(parts.breaks);
  parts.given = kept.ofCorners(parts.given);
  parts.scales.ofTriangle = kept.ofTriangles(parts.scales.ofTriangle);
  keepOnly(kept, parts.surface, parts.fixed);
  addMatch(found);
}

bool Stacks::leaveOutCharts(const IdVector<ChartId, ChartConstraints>& constraints,
                            const CutParts& parts) {
  if (!mayStack()) return false;
  const CutMesh mesh{{input_, welded_, parts.surface}, parts.charts.set};
  const CornerMatch found = alikeCharts(mesh, constraints, parts.charts.flat, options_, unfit_);
  if (found.empty()) return false;
  const IdVector<SurfaceTriangle, std::uint8_t> isKept = areModels(parts.surface, found);
  parts.open = keptCharts(parts.open, isKept);
  LaidCharts all = std::move(parts.charts);
  parts.charts = {chartsOf(welded_, parts.open), {}};
  // Charts are in the order of their first triangles, before and after.
  for (const ChartId i : all.set.ids())
    if (isKept[all.set.topology(i).triangles.front()])
      parts.charts.flat.push_back(std::move(all.flat[i]));
  keepOnly(KeptTriangles(isKept), parts.surface, parts.fixed);
  addMatch(found);
  return true;
}

void Stacks::keepOnly(const KeptTriangles& kept, Surface& surface, FixedTriangles& fixed) {
  Surface part = kept.surface(surface, welded_.mesh.vertexCount());
  fixed = kept.fixed(std::move(fixed));
  if (!isAny()) whole_ = std::move(surface);
  surface = std::move(part);
}

/// `found`: within what has been left in so far.
void Stacks::addMatch(const CornerMatch& found) {
  if (!isAny()) {
    model_ = found;
    return;
  }
  for (PolygonCorner& c : model_)
    if (c.exists()) c = found[c];
}

Seams Stacks::addAgain(const CutParts& parts) {
  SpreadCharts all = spread(welded_, whole_, model_, {parts.surface, parts.open, parts.charts});
  parts.surface = std::move(whole_);
  parts.charts = std::move(all.charts);
  modelOf_ = std::move(all.modelOf);
  model_ = CornerMatch();
  return std::move(all.seams);
}

void Stacks::check(const UnwrapReport& report) {
  const auto below = [&](ChartId i) {
    const int on = report.charts[i].stackedOn;
    return on < 0 ? i : ChartId(on);
  };
  for (const ChartId i : modelOf_.ids()) {
    const ChartId model = modelOf_[i];
    if (below(i) != below(model) || report.charts[i].valid != report.charts[model].valid)
      unfit_.push_back(report.charts[i].firstFace);
  }
}

Result<UnwrapResult> untilStacksFit(std::size_t faces,
                                    const std::function<Result<UnwrapResult>(UnfitFaces&)>& run) {
  constexpr int kMostRuns = 4;
  UnfitFaces unfit;
  for (int k = 1;; ++k) {
    const std::size_t before = unfit.size();
    Result<UnwrapResult> out = run(unfit);
    if (!out.ok() || unfit.size() == before) return out;
    if (k < kMostRuns) continue;
    unfit.resize(faces);
    std::iota(unfit.begin(), unfit.end(), 0u);
  }
}

}  // namespace abflat
