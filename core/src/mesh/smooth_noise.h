#pragma once

#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/listener.h"
#include "mesh/surface.h"

namespace abflat {

/// A surface without detail that is too small to be seen.
struct Smoothed {
  std::vector<double> positions;
  std::size_t triangles = 0;  ///< of the parts that are smoothed; 0: none is
};

/// Moves vertices towards the middle of their neighbours, by no more than `reach`. Only parts that
/// thereby lose much of their area and of their bends are changed: those of steps and grain, not
/// those that are smooth, thin or have creases, those of few triangles, and those that would hardly
/// be left.
Smoothed smoothNoise(const PolygonMesh& mesh, const Surface& surface, double reach,
                     const Listener& listener = {});

}  // namespace abflat
