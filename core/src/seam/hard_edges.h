#pragma once

#include "cut/cut_surface.h"
#include "mesh/surface_map.h"

namespace abflat {

/// Normals that differ by less are the same but for rounding, as when 8-bit numbers hold them.
constexpr double kSameNormalDegrees = 1;

/// Marks both half-edges of each edge whose shading normals differ at one of its ends or at both.
/// Corners without a normal have that of their triangle. If there are no normals, smoothing groups
/// decide: normals differ between groups, and between faces that are in none and not in one plane.
/// Empty if the mesh has neither.
Seams hardEdges(const SurfaceMap& map);

/// Adds kMaterialBorder to both half-edges of each edge between faces of different materials.
void addMaterialBorders(const SurfaceMap& map, Seams& breaks);

}  // namespace abflat
