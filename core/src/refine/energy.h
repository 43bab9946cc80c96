#pragma once

#include "refine/balanced_energy.h"

namespace abflat {

/// The energy of a triangle that refining lowers, given the map from its shape on the surface to
/// its shape in the layout, which preserves orientation. It is the same in all directions, so it is
/// a function of P = |z|^2 and Q = |w|^2. Rigid maps have the least. It is made from the balance,
/// and has
///
///   kAtRest            its value for a rigid map
///   at(p, q)           its value
///   derivatives(p, q)  SquareDerivatives
///   secantShare(r)     for a scaling by r: the secant of its slope from r to 1, as a share of its
///                      curvature at r
///   bestScale(forMaps) the factor for all maps that makes the weighted sum of their energies
///                      least; forMaps(use) calls use(weight, map) for each
///   shareLeft()        how much of a chart's stretch above 1 refining leaves, as a share; hardly
///                      depends on the chart
///
/// Another energy is one more class like this, in a file of its own.
using Energy = BalancedEnergy;

}  // namespace abflat
