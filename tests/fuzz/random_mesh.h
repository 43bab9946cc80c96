#pragma once

#include "abflat/mesh.h"
#include "random_source.h"

namespace abflat::fuzz {

/// A mesh of at most a few hundred faces: a shape that people make or that has broken something,
/// then a few of the defects that files have. All indices are in range.
PolygonMesh randomMesh(RandomSource& random);

/// The same without defects, and mostly a topological disk.
PolygonMesh randomDisk(RandomSource& random);

}  // namespace abflat::fuzz
