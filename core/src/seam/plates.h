#pragma once

#include "cut/cut_surface.h"

namespace abflat {

/// The borders of flat regions with several holes, such as the front and back of a grille, where
/// these are creases. A chart that bends round the rim of each hole needs many more seams than
/// these. Empty if there are no such regions.
Seams plateBorders(const SeamMesh& mesh);

}  // namespace abflat
