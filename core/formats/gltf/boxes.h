#pragma once

#include "gltf/document.h"

namespace abflat::gltf {

/// Gives accessors of decoded views the `min` and `max` of their values: compression with loss
/// leaves those from before.
void refreshBoxes(Document& document, Complaints& complaints);

}  // namespace abflat::gltf
