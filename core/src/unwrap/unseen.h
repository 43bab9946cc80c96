#pragma once

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "chart/chart_set.h"
#include "mesh/smooth_noise.h"
#include "mesh/surface.h"
#include "mesh/welded_mesh.h"
#include "unwrap/chart.h"

namespace abflat {

/// Edges that are shorter, in units of the welded mesh, are so fine that steps of the surface bend
/// them at random.
double fineLength(const WeldedMesh& welded, const CornerTable& table, const UnwrapOptions& options,
                  double unit);

/// The surface without steps and grain that the texels of the atlas cannot show, which would cost
/// seams. Nothing is smoothed where parts of the mesh have texcoords already. `unit`: of the welded
/// mesh, in units of the input.
Smoothed withoutUnseen(const WeldedMesh& welded, const Surface& surface,
                       const UnwrapOptions& options, double unit, const Listener& listener);

/// Empty if nothing is smoothed.
std::string unseenNote(const Smoothed& smoothed);

/// Measures charts on the true surface: the `positions` that the mesh of the set has again, drawn
/// after the `smoothed` ones. `modelOf`: the chart after which each was drawn; empty: itself.
void measureUnseen(const ChartSet& set, const IdVector<ChartId, ChartId>& modelOf,
                   const std::vector<double>& smoothed, const std::vector<double>& positions,
                   ThreadPool& pool, FlatCharts& flat);

}  // namespace abflat
