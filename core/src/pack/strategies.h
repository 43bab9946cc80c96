#pragma once

#include "pack/placer.h"

namespace abflat {

/// Up to this many items are placed in many ways.
constexpr std::size_t kFewItems = 40;
/// More than this are tidy from the start: the work allows few tries.
constexpr std::size_t kSeveralItems = 150;
/// More than this are placed in one way only.
constexpr std::size_t kManyItems = 1000;

/// With this tidiness charts lie at odd angles only where they would not fit otherwise, with less
/// where they lie lower by about their size.
constexpr double kTidiest = 8, kLessTidy = 1;

/// How many poses items need for the strategies, beside those that are level.
int posesFor(std::size_t items, Rotate rotate);

/// The most promising strategy, with all poses.
PlaceStrategy largestFirst(const std::vector<PackItem>& items);

/// Ways to place the items that are worth trying, the most promising first. Which of them packs
/// best is a matter of luck, so there are more for few items, which are cheap to place. Without
/// tidiness, all poses count alike.
std::vector<PlaceStrategy> strategiesFor(const std::vector<PackItem>& items, double tidiness);

}  // namespace abflat
