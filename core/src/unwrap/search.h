#pragma once

#include <vector>

#include "unwrap/flatten_cut.h"
#include "unwrap/open_and_fill.h"
#include "unwrap/passes.h"
#include "unwrap/seam_variant.h"

namespace abflat {

/// What a search for seams starts from.
struct SearchInput {
  UncutSurface uncut;
  const AskedCuts& asked;
};

/// How many more searches there will be if all are fruitless: after a few in a row the rest are
/// left out. Before anything is known of the surface, and once it is cut.
double expectedSearches(std::size_t triangles);
double expectedSearches(const std::vector<SeamVariant>& variants, const OpenSurface& open);

/// Cuts the surface in other ways, too; each component keeps what turns out best. Then joins charts
/// that are too small to be worth a seam, and lays all out as asked. `variants`: those worth their
/// time. `cut`: what the first search found. `settings`: for what is laid out in the end.
Status searchMore(const SearchInput& input, const std::vector<SeamVariant>& variants,
                  const FlattenSettings& settings, Passes passes, FlatCut& cut);

}  // namespace abflat
