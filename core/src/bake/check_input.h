#pragma once

#include "abflat/bake.h"

namespace abflat {

/// Whether all sizes and numbers fit each other.
Status checkInput(const BakeInput& input, MapKind kind);
Status checkOptions(const BakeOptions& options);

}  // namespace abflat
