#pragma once

#include "pack/placer.h"

namespace abflat {

/// That many are placed in many ways.
constexpr std::size_t kFewItems = 40;
/// More are placed in one way only.
constexpr std::size_t kManyItems = 1000;

/// Poses that items need for the strategies.
int posesFor(std::size_t items);

/// The one most promising, with so many angles.
PlaceStrategy largestFirst(const std::vector<PackItem>& items, int angles);

/// Ways to place the items that are worth trying, the most promising first. Which of them packs
/// best is a matter of luck: where there are few items, so that placing is cheap, there are more.
std::vector<PlaceStrategy> strategiesFor(const std::vector<PackItem>& items);

}  // namespace abflat
