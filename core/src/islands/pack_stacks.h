#pragma once

#include "abflat/pack_layout.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "islands/read_layout.h"
#include "pack/pack.h"

namespace abflat {

/// Finds a place for each stack, all in one tile or each in its own.
Result<Packing> packStacks(MeshLayout& layout, const PackLayoutOptions& options, ThreadPool& pool,
                           const Listener& listener);

}  // namespace abflat
