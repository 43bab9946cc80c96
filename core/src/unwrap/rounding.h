#pragma once

#include <string>
#include <vector>

#include "unwrap/packed_charts.h"

namespace abflat {

/// The numbers that texcoords are written as: those of a glTF are in single precision, with v from
/// the top.
enum class Numbers { Double, Gltf };

/// Moves the layouts to their places in the atlas.
void placeInAtlas(const Packing& packing, FlatCharts& flat);

/// To single precision, see roundInAtlas, so that 1 - v is one as well. Returns how many charts
/// that were valid are not any more.
std::size_t roundToSingle(const ChartSet& charts, ThreadPool& pool, FlatCharts& flat);

/// Rounds charts that lie in the atlas and decides anew which are valid. What was valid by itself
/// and is not any more is made so where it can be: a chart within a texel grows, up to all of it,
/// and vertices of triangles that are thinner than numbers can tell are moved. Returns how many
/// charts have to be larger, which is only said where they `mayGrow`: they are to be packed again
/// with their new `enlarged`.
std::size_t fitToNumbers(const PackedCharts& packed, Numbers numbers, int resolution, bool mayGrow);

/// Which charts are larger than others, and which vertices were moved.
std::vector<std::string> fittingNotes(const FlatCharts& flat, Numbers numbers);

}  // namespace abflat
