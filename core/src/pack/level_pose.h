#pragma once

#include "pack/pose.h"

namespace abflat {

/// How a shape should lie, and what speaks for it.
struct LevelPose {
  Pose pose;
  bool isLevel = false;     ///< straight edges of its outline lie along u and v
  bool isStraight = false;  ///< so does most of its outline
  bool isUpright = false;   ///< its up direction decided
};

/// Turns straight edges of a shape's outline along u and v, and `up` towards +v. `up` is the image
/// of the mesh's up direction, as long as the height gained per length: 1 on a wall, 0 on a floor,
/// which does not stand. Where the two disagree, the edges win if there are many of them, and more
/// than are level where the shape stands upright; where they nearly agree, always. A shape
/// with neither lies in its smallest box. Follows from the geometry alone: turning the shape and
/// `up` together changes nothing.
LevelPose levelPose(const Loops& loops, const std::vector<PlanePoint>& hull, PlanePoint up);

}  // namespace abflat
