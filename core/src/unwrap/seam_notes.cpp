#include "unwrap/seam_notes.h"

#include "base/number_text.h"

namespace abflat {

std::string scaleNote(const ScaleJump& jump, const SurfaceMap& map, double unit) {
  const auto face = [&](auto triangle) {
    return "face " + std::to_string(std::uint32_t{map.face(triangle)});
  };
  return "faces of very different sizes are cut apart: " + face(jump.large) + " is " +
         withDigits(jump.largeSide * unit, 3) + " long, its neighbour, " + face(jump.small) +
         ", is " + withDigits(jump.smallSide * unit, 3);
}

std::string asymmetryNote(const OpenSurface& open, const UnwrapOptions& options) {
  if (!options.seams.isAuto || options.symmetricSeams != SymmetricSeams::Always || open.mirror)
    return {};
  const std::string what = "seams are not symmetric: ";
  if (open.asymmetry == Asymmetry::NoPlane) return what + "the mesh is not its own mirror image";
  if (open.asymmetry == Asymmetry::SeamsGiven) return what + "some seams or islands were given";
  return what + "charts would be stretched too much or overlap themselves";
}

}  // namespace abflat
