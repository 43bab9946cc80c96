#pragma once

#include "base/listener.h"
#include "base/parallel.h"
#include "mesh/surface_map.h"
#include "unwrap/cut_mesh.h"
#include "unwrap/fixed.h"
#include "unwrap/flat_cut.h"
#include "unwrap/stage_times.h"

namespace abflat {

/// What the charts of a cut surface are laid out with.
struct FlattenSettings {
  SurfaceMap map;
  const FixedTriangles& fixed;
  const UnwrapOptions& options;
  ThreadPool& pool;
  Listener listener;
  StageTimes& times;
  double UnwrapStages::*stage = &UnwrapStages::solve;  ///< whose time layouts take
  /// A search for seams takes no notice of pins and of what is known, so that these change none.
  bool isSearch = false;
  /// What is known already: flatten() gives up what cannot become better. Null: it never gives up.
  FlatCut* rival = nullptr;
};

/// Lays out the charts of cut surfaces, and cuts them further where they are stretched too much.
/// What is stopped leaves charts without a layout.
class CutFlattener {
 public:
  explicit CutFlattener(FlattenSettings settings) : with_(std::move(settings)) {}

  /// Sets the charts of the surface with its present seams, none of which is laid out. Errors, of
  /// this and of the next two: those of chartConstraints.
  Status takeCharts(FlatCut& cut) const;
  /// The same, but what has not changed keeps its layout. `before`: the charts until now, and what
  /// is left of their layouts.
  Status takeChartsAnew(FlatCut& cut, LaidCharts& before) const;
  Status takeChartsAnew(FlatCut& cut) const;

  /// Sets the constraints on the charts.
  Status constrain(FlatCut& cut) const;

  /// Lays out charts that have no layout yet.
  Status layOut(FlatCut& cut) const;

  /// Flattens all charts, and cuts those further that are stretched more than predicted, unless
  /// that is hopeless.
  Status flatten(FlatCut& cut) const;

  /// Lays out pieces that cannot keep their place in the former chart's layout. Pieces that are
  /// still stretched too much are cut further.
  Status layOutPieces(FlatCut& cut) const;

  /// Splits charts in two that rounding has made invalid, and lays out the parts. False if there is
  /// none that can be split.
  Result<bool> halveInvalid(FlatCut& cut) const;

  /// Takes back what was changed about these charts of `before`, which had those seams.
  Status takeBack(LaidCharts& before, const IdVector<ChartId, std::uint8_t>& isAsked,
                  const Seams& seams, FlatCut& cut) const;

  const FlattenSettings& settings() const { return with_; }

 private:
  class Rounds;

  Status layOut(FlatCut& cut, const Listener& listener) const;
  Status halveRuined(FlatCut& cut, Rounds& rounds) const;
  Result<bool> halve(FlatCut& cut, const IdVector<ChartId, std::uint8_t>& isAsked) const;
  Status cutWhileStretched(FlatCut& cut, int mostRounds, Rounds& rounds) const;
  bool cutFurther(FlatCut& cut, const Listener& listener) const;
  bool giveUp(FlatCut& cut) const;
  Status endSearch(FlatCut& cut, const Listener& listener) const;
  CutMesh meshOf(const FlatCut& cut) const { return {with_.map, cut.charts.set}; }

  FlattenSettings with_;
};

}  // namespace abflat
