#pragma once

#include "mesh/ids.h"

namespace abflat {

/// Of a surface that is opened along its seams. A vertex that seams pass is several of them.
using OpenVertex = Id<struct OpenVertexTag>;

/// A chart of such a surface. What is taken out of a hole is a chart as well, so that ChartId,
/// which counts the charts of the result, is another number.
using CutChartId = Id<struct CutChartTag>;

/// A boundary loop of such a surface.
using LoopId = Id<struct LoopTag>;

/// A hole that has been filled.
using HoleId = Id<struct HoleTag>;

}  // namespace abflat
