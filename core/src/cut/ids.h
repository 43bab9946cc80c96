#pragma once

#include "mesh/ids.h"

namespace abflat {

/// A vertex of a surface that is opened along its seams. One that seams pass through becomes
/// several.
using OpenVertex = Id<struct OpenVertexTag>;

/// A chart of such a surface. The filling taken out of a hole is a chart as well, so this number
/// differs from ChartId, which counts the charts of the result.
using CutChartId = Id<struct CutChartTag>;

/// A boundary loop of such a surface.
using LoopId = Id<struct LoopTag>;

/// A hole that has been filled.
using HoleId = Id<struct HoleTag>;

}  // namespace abflat
