#pragma once

#include <string>
#include <vector>

#include "unwrap/packed_charts.h"

namespace abflat {

/// How texcoords are written. A glTF holds them in single precision, with v from the top.
enum class Numbers { Double, Gltf };

/// Moves the layouts to their places in the atlas.
void placeInAtlas(const Packing& packing, FlatCharts& flat);

/// Rounds to single precision as roundInAtlas does, so that 1 - v is exact as well. Returns how
/// many charts that were valid no longer are.
std::size_t roundToSingle(const ChartSet& charts, ThreadPool& pool, FlatCharts& flat);

/// Rounds charts that lie in the atlas and decides again which are valid. Charts that only rounding
/// made invalid are repaired if possible: a chart within a texel grows to fill it at most, and
/// vertices of triangles too thin for the numbers are moved. Returns how many charts have to be
/// larger, which can only happen if they `mayGrow`; they then have to be packed again with their
/// new `enlarged`.
std::size_t fitToNumbers(const PackedCharts& packed, Numbers numbers, const AtlasSize& resolution,
                         bool mayGrow);

/// Notes on which charts are larger than others, and which vertices were moved.
std::vector<std::string> fittingNotes(const FlatCharts& flat, Numbers numbers);

}  // namespace abflat
