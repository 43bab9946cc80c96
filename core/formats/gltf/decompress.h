#pragma once

#include "gltf/document.h"

namespace abflat::gltf {

/// Turns a document that is compressed by Draco or meshopt into a plain one, before anything but
/// its JSON and its buffers has been read. Decoded bytes become buffers of their own, views and
/// accessors keep their indices, and all trace of the extensions is removed.
void decompress(Document& document, Complaints& complaints);

}  // namespace abflat::gltf
