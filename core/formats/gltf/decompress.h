#pragma once

#include "gltf/document.h"

namespace abflat::gltf {

/// Makes a plain document of one that is compressed by Draco or meshopt, before anything but its
/// JSON and its buffers has been read. Decoded bytes become buffers of their own, views and
/// accessors keep their numbers, and all trace of the extensions goes.
void decompress(Document& document, Complaints& complaints);

}  // namespace abflat::gltf
