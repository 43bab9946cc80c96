#include "mesh/face_walk.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "base/stable_order.h"
#include "mesh/uncross.h"

namespace abflat {
namespace {

/// Keeps the first of each run of corners at the same place.
void leaveOutRuns(const std::vector<std::uint32_t>& places, FaceWalk& walk) {
  CornerLoop& kept = walk.corners;
  for (std::uint32_t k = 0; k < places.size(); ++k) {
    const bool isSame = !kept.empty() && places[k] == places[kept.back()];
    walk.same.push_back(isSame ? kept.back() : k);
    if (!isSame) kept.push_back(k);
  }
  while (kept.size() > 1 && places[kept.back()] == places[kept.front()]) {
    walk.same[kept.back()] = kept.front();
    kept.pop_back();
  }
}

std::vector<std::uint32_t> placesOf(const CornerLoop& corners,
                                    const std::vector<std::uint32_t>& places) {
  std::vector<std::uint32_t> out;
  out.reserve(corners.size());
  for (const std::uint32_t k : corners) out.push_back(places[k]);
  return out;
}

/// Per corner, whether an earlier one is at the same place.
std::vector<std::uint8_t> revisits(const std::vector<std::uint32_t>& places) {
  const CornerLoop order = stableOrder(
      places.size(), [&](std::uint32_t a, std::uint32_t b) { return places[a] < places[b]; });
  std::vector<std::uint8_t> out(places.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i)
    out[order[i]] = places[order[i]] == places[order[i - 1]];
  return out;
}

/// Leaves out corners from which the walk returns to where it came from, and does so again with
/// what is left, as far as these `mayGo`. False if there are none.
bool leaveOutSpikes(const std::vector<std::uint32_t>& places,
                    const std::function<bool(std::uint32_t)>& mayGo, FaceWalk& walk) {
  CornerLoop out;
  const auto isSpike = [&](std::uint32_t a, std::uint32_t tip, std::uint32_t b) {
    return places[a] == places[b] && mayGo(tip);
  };
  for (const std::uint32_t k : walk.corners) {
    out.push_back(k);
    for (std::size_t n = out.size(); n >= 3 && isSpike(out[n - 3], out[n - 2], out[n - 1]);
         n = out.size()) {
      walk.same[out[n - 1]] = out[n - 3];
      out.resize(n - 2);
    }
  }
  std::size_t first = 0;  // the walk is closed
  for (std::size_t n = out.size(); n >= first + 3; n = out.size()) {
    if (isSpike(out[n - 2], out[n - 1], out[first])) {
      walk.same[out[n - 2]] = out[first];
      out.resize(n - 2);
    } else if (isSpike(out[n - 1], out[first], out[first + 1])) {
      walk.same[out[n - 1]] = out[first + 1];
      out.pop_back();
      ++first;
    } else {
      break;
    }
  }
  out.erase(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(first));
  walk.corners.swap(out);
  return walk.corners.size() < out.size();
}

std::vector<std::uint8_t> boundsSomething(const Inside& inside, std::size_t corners) {
  std::vector<std::uint8_t> out(corners, 0);
  for (const CornerLoop& loop : inside.loops)
    for (const std::uint32_t i : loop) out[i] = 1;
  return out;
}

/// Makes the polygon simple, and sorts its corners where it crosses itself at places.
Opening openingOf(const std::vector<double>& positions, const std::vector<std::uint32_t>& places,
                  const Inside& inside, const std::vector<std::uint8_t>& bounds,
                  CornerLoop& corners) {
  const std::vector<std::uint32_t> at = placesOf(corners, places);
  if (!inside.loops.empty()) {
    const CornerLoop order = uncross(positions, at, bounds);
    CornerLoop sorted;
    std::vector<std::uint8_t> sortedBounds;
    for (const std::uint32_t i : order) {
      sorted.push_back(corners[i]);
      sortedBounds.push_back(bounds[i]);
    }
    if (!order.empty())
      if (auto opening = openNecks(positions, placesOf(sorted, places), sortedBounds)) {
        corners = std::move(sorted);
        return std::move(*opening);
      }
  }
  CornerLoop again;
  const std::vector<std::uint8_t> isAgain = revisits(at);
  for (std::uint32_t i = 0; i < isAgain.size(); ++i)
    if (isAgain[i]) again.push_back(i);
  return openEach(positions, at, again);
}

}  // namespace

FaceWalk walkAround(const std::vector<double>& positions,
                    const std::vector<std::uint32_t>& places) {
  FaceWalk out;
  leaveOutRuns(places, out);
  const auto isSimple = [&] {
    const std::vector<std::uint8_t> again = revisits(placesOf(out.corners, places));
    return std::find(again.begin(), again.end(), 1) == again.end();
  };
  if (out.corners.size() < 3 || isSimple()) return out;
  Inside inside = insideLoops(positions, placesOf(out.corners, places));
  std::vector<std::uint8_t> bounds = boundsSomething(inside, out.corners.size());
  std::vector<std::uint8_t> isKept(places.size(), 0);
  for (std::size_t i = 0; i < bounds.size(); ++i) isKept[out.corners[i]] = bounds[i];
  const auto mayGo = [&](std::uint32_t k) { return !isKept[k]; };
  if (leaveOutSpikes(places, mayGo, out)) {
    if (out.corners.size() < 3 || isSimple()) return out;
    if (!inside.loops.empty()) inside = insideLoops(positions, placesOf(out.corners, places));
    bounds = boundsSomething(inside, out.corners.size());
  }
  out.opening = openingOf(positions, places, inside, bounds, out.corners);
  return out;
}

}  // namespace abflat
