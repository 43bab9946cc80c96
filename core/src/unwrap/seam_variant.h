#pragma once

#include "unwrap/open_and_fill.h"

namespace abflat {

/// Which of several searches for seams it is.
struct SeamVariant {
  int costs = 0;                        ///< see varyCosts
  bool isTighter = false;               ///< within half the bound of the stretch
  const OpenSurface* before = nullptr;  ///< what another search found; null: this is the first one
};

}  // namespace abflat
