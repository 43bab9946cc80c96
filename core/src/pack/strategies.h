#pragma once

#include "pack/placer.h"

namespace abflat {

/// Up to this many items are placed in many ways.
constexpr std::size_t kFewItems = 40;
/// More than this are placed in one way only.
constexpr std::size_t kManyItems = 1000;

/// How many poses items need for the strategies.
int posesFor(std::size_t items);

/// The most promising strategy, with the given number of angles.
PlaceStrategy largestFirst(const std::vector<PackItem>& items, int angles);

/// Ways to place the items that are worth trying, the most promising first. Which of them packs
/// best is a matter of luck, so there are more for few items, which are cheap to place.
std::vector<PlaceStrategy> strategiesFor(const std::vector<PackItem>& items);

}  // namespace abflat
