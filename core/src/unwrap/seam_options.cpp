#include "unwrap/seam_options.h"

#include <algorithm>

#include "pack/pack.h"
#include "refine/refine.h"
#include "unwrap/expected_density.h"

namespace abflat {

SeamOptions seamOptions(const UnwrapOptions& options, const OpenSurface& open, ThreadPool& pool,
                        const Listener& listener, int variant) {
  SeamOptions out;
  out.variant = variant;
  out.isAuto = options.seams.isAuto;
  out.maxStretch = stretchBeforeRefining(options.maxStretch, Energy(options.balance));
  if (options.seamCosts == SeamCosts::Length) out.prices = SeamPrices::none();
  out.symmetricSeams = options.symmetricSeams;
  out.fillHoles = options.fillHoles;
  constexpr double kSpeckTexels = 16;
  out.speck = kSpeckTexels / expectedDensity(options, open.mesh.totalArea(), open.unit);
  if (options.udim)  // each chart has to fit a tile
    out.longest =
        (options.resolution.shorter() - 2 * std::max(options.padding, marginOf(options))) /
        options.texelDensity / open.unit;
  out.pool = &pool;
  out.listener = listener;
  return out;
}

}  // namespace abflat
