#pragma once

#include "base/ids.h"

namespace abflat {

/// One of the disks that a surface is cut into.
using ChartId = Id<struct ChartTag>;

/// A texcoord of the result. They are numbered chart by chart, one for each vertex of a chart.
using TexcoordId = Id<struct TexcoordTag>;

}  // namespace abflat
