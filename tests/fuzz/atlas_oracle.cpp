#include "atlas_oracle.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "exact_turn.h"

namespace abflat::fuzz {
namespace {

std::string named(const char* what, std::size_t triangle) {
  return "triangle " + std::to_string(triangle) + " " + what;
}

/// Number of the tile around a triangle, -1 where there is none; borders belong to both sides.
int tileOf(const double* t) {
  const auto [left, right] = std::minmax({t[0], t[2], t[4]});
  const auto [low, high] = std::minmax({t[1], t[3], t[5]});
  if (!(left >= 0 && right <= 10 && low >= 0 && high < 1e6)) return -1;
  const double column = std::max(0.0, std::ceil(right) - 1),
               row = std::max(0.0, std::ceil(high) - 1);
  if (left < column || low < row) return -1;
  return static_cast<int>(10 * row + column);
}

/// A line along an edge of `a` has `b` on its other side.
bool isBehindAnEdge(const double* a, const double* b) {
  for (int k = 0; k < 3; ++k) {
    const double *from = a + 2 * k, *to = a + 2 * ((k + 1) % 3);
    if (exactTurn(from, to, b) <= 0 && exactTurn(from, to, b + 2) <= 0 &&
        exactTurn(from, to, b + 4) <= 0)
      return true;
  }
  return false;
}

bool boxesMeet(const double* a, const double* b) {
  for (int d = 0; d < 2; ++d) {
    const auto [lowA, highA] = std::minmax({a[d], a[d + 2], a[d + 4]});
    const auto [lowB, highB] = std::minmax({b[d], b[d + 2], b[d + 4]});
    if (!(lowA < highB && lowB < highA)) return false;
  }
  return true;
}

}  // namespace

bool doOverlap(const double* a, const double* b) {
  return boxesMeet(a, b) && !isBehindAnEdge(a, b) && !isBehindAnEdge(b, a);
}

namespace {

std::string overlap(const std::vector<double>& uv, std::vector<std::size_t> solid) {
  const auto left = [&](std::size_t i) {
    return std::min({uv[6 * i], uv[6 * i + 2], uv[6 * i + 4]});
  };
  const auto right = [&](std::size_t i) {
    return std::max({uv[6 * i], uv[6 * i + 2], uv[6 * i + 4]});
  };
  std::sort(solid.begin(), solid.end(),
            [&](std::size_t a, std::size_t b) { return left(a) < left(b); });
  std::vector<std::size_t> open;
  for (const std::size_t i : solid) {
    const double* t = &uv[6 * i];
    open.erase(std::remove_if(open.begin(), open.end(),
                              [&](std::size_t j) { return right(j) <= left(i); }),
               open.end());
    for (const std::size_t j : open)
      if (doOverlap(t, &uv[6 * j]))
        return "triangles " + std::to_string(std::min(i, j)) + " and " +
               std::to_string(std::max(i, j)) + " overlap";
    open.push_back(i);
  }
  return {};
}

}  // namespace

std::string overlapComplaint(const AtlasTriangles& triangles) {
  std::vector<std::size_t> solid;
  for (std::size_t i = 0; 6 * i < triangles.uv.size(); ++i) {
    const double* t = &triangles.uv[6 * i];
    if (!std::all_of(t, t + 6, [](double x) { return std::isfinite(x); }))
      return named("is not finite", i);
    const int turn = exactTurn(t, t + 2, t + 4);
    if (turn < 0) return named("is turned over", i);
    if (turn == 0 && !triangles.mayBeFlat[i]) return named("has no area", i);
    if (turn > 0) solid.push_back(i);
  }
  return overlap(triangles.uv, std::move(solid));
}

std::string complaint(const AtlasTriangles& triangles, int tiles) {
  for (std::size_t i = 0; 6 * i < triangles.uv.size(); ++i) {
    const int tile = tileOf(&triangles.uv[6 * i]);
    if (tile < 0 || tile >= tiles) return named("is in no tile", i);
  }
  return overlapComplaint(triangles);
}

}  // namespace abflat::fuzz
