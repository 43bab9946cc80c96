#include "islands/describe_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "base/counted.h"
#include "islands/check_places.h"
#include "islands/judge_faces.h"

namespace abflat {
namespace {

/// The number of tiles that have islands, or the area of all tiles around the layout where an
/// island is larger than one.
double roomBefore(const std::vector<IslandStack>& stacks) {
  constexpr double kSide = 1.01;  // islands may be a little beyond their tile
  std::set<std::array<double, 2>> tiles;
  UvBox all;
  bool isWithin = true;
  for (const IslandStack& stack : stacks) {
    tiles.insert({std::floor(stack.middle(0)), std::floor(stack.middle(1))});
    for (const auto& corner : {stack.box.low, stack.box.high}) all.add(corner.data());
    for (std::size_t d = 0; d < 2; ++d)
      isWithin = isWithin && stack.box.high[d] - stack.box.low[d] <= kSide;
  }
  if (isWithin) return static_cast<double>(tiles.size());
  return (std::ceil(all.high[0]) - std::floor(all.low[0])) *
         (std::ceil(all.high[1]) - std::floor(all.low[1]));
}

std::size_t countMirrored(const IslandTriangles& triangles) {
  std::size_t out = 0;
  for (std::uint32_t i = 0; i < triangles.islands(); ++i) {
    double area = 0;
    for (const double* t = triangles.of(i); t != triangles.of(i + 1); t += 6) area += doubleArea(t);
    out += area < 0;
  }
  return out;
}

void countIslands(const MeshLayout& layout, PackReport& report) {
  report.islands = layout.stackOfIsland.size();
  report.unmapped = static_cast<std::size_t>(
      std::count(layout.islandOfFace.begin(), layout.islandOfFace.end(), kNoIsland));
  report.separated = layout.separated;
  report.mirrored = countMirrored(layout.triangles.inUv);
  for (const IslandStack& stack : layout.stacks) {
    report.stackedIslands += stack.islands.size() - 1;
    report.stackedStacks += stack.islands.size() > 1;
  }
}

/// Area in uv for an area of 1 in the stack's shape. Where nothing moves there are no placements.
double stackGrowth(const Packing& packing, std::size_t stack) {
  if (stack >= packing.placements.size()) return packing.scale;
  const Placement& p = packing.placements[stack];
  return (p.a * p.a + p.b * p.b) * p.stretchU * p.stretchV * p.aspect;
}

void measureScale(const MeshLayout& layout, const Packing& packing,
                  const PackLayoutOptions& options, PackReport& report) {
  double before = 0, now = 0, covered = 0, onSurface = 0;
  for (std::size_t s = 0; s < layout.stacks.size(); ++s) {
    const IslandStack& stack = layout.stacks[s];
    const double growth = stackGrowth(packing, s) * stack.factor * stack.factor / stack.aspect;
    before += stack.uvArea;
    now += stack.uvArea * growth;
    covered += stack.coveredArea;
    onSurface += stack.surfaceArea;
  }
  report.scale = std::sqrt(areaRatio(now, before));
  report.utilizationBefore = covered / roomBefore(layout.stacks);
  report.utilization = packing.utilization;
  report.texelDensity = options.resolution.meanSide() *
                        std::ldexp(std::sqrt(areaRatio(now, onSurface)), -layout.exponent);
}

void addNotes(const MeshLayout& layout, const PackLayoutOptions& options, PackReport& report) {
  if (options.keepPlaces) return;  // they tell what has changed
  if (!options.resolution.isSquare() && options.islands.empty() && layout.stacks[0].aspect == 1)
    report.notes.emplace_back(
        "the layout was made for a square texture, as its angles show; islands keep their shapes");
  const auto note = [&](std::size_t n, const char* one, const char* many) {
    if (n > 0) report.notes.push_back(counted(n, one, many));
  };
  note(report.stackedIslands, "island lies on another and moved together with it",
       "islands lie on others and moved together with them");
  note(report.separated,
       "island overlapped another by less than half, or one of another material, and is apart now",
       "islands overlapped others by less than half, or of other materials, and are apart now");
  note(report.unmapped, "face has no texcoords and stays as it was",
       "faces have no texcoords and stay as they were");
}

PlacedTriangles placedTriangles(const MeshLayout& layout, const PlacedTexcoords& texcoords) {
  const MappedTriangles& triangles = layout.triangles;
  PlacedTriangles out;
  out.face = triangles.face;
  out.uv.reserve(6 * triangles.corners.size());
  for (const std::uint32_t f : triangles.face) out.stack.push_back(layout.stackOf(f));
  for (const auto& corners : triangles.corners)
    for (const std::uint32_t c : corners) {
      const double* uv = &texcoords.uv[2 * std::size_t{texcoords.cornerUv[c]}];
      out.uv.insert(out.uv.end(), {uv[0], uv[1]});
    }
  return out;
}

/// In the order of the triangles of the mesh; those without texcoords have none.
std::vector<std::uint8_t> inMeshOrder(const MeshLayout& layout,
                                      const std::vector<std::uint8_t>& faults) {
  std::vector<std::uint8_t> out(layout.triangleCorners.size() / 3);
  for (std::size_t i = 0; i < faults.size(); ++i) out[layout.triangles.ofMesh[i]] = faults[i];
  return out;
}

}  // namespace

std::vector<std::uint8_t> describeLayout(const MeshLayout& layout, const Packing& packing,
                                         const PlacedTexcoords& texcoords,
                                         const PackLayoutOptions& options, PackReport& report) {
  report.resolution = options.resolution.longer();
  report.width = options.resolution.width;
  report.height = options.resolution.height;
  report.padding = options.padding;
  report.margin = marginOf(options);
  report.tiles = static_cast<int>(packing.tiles);
  countIslands(layout, report);
  measureScale(layout, packing, options, report);
  if (options.keepPlaces) report.utilization = report.utilizationBefore;
  addNotes(layout, options, report);
  const PlacedTriangles placed = placedTriangles(layout, texcoords);
  const std::vector<std::uint8_t> faults = faultsOf(placed, packing.tiles);
  countFaults(placed.face, faults, report);
  std::string problem = problemOf(placed, packing.tiles);
  report.valid = problem.empty();
  if (!report.valid) report.notes.push_back(std::move(problem));
  return inMeshOrder(layout, faults);
}

}  // namespace abflat
