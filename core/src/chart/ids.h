#pragma once

#include "base/ids.h"

namespace abflat {

/// One of the disks that a surface is cut into.
using ChartId = Id<struct ChartTag>;

/// A texcoord of the result: charts follow each other, and each has one for each of its vertices.
using TexcoordId = Id<struct TexcoordTag>;

}  // namespace abflat
