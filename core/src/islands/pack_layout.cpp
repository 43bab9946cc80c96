#include "abflat/pack_layout.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "abflat/inspect.h"
#include "base/guarded.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "islands/describe_layout.h"
#include "islands/find_islands.h"
#include "islands/old_aspect.h"
#include "islands/pack_stacks.h"
#include "islands/place_texcoords.h"
#include "islands/read_layout.h"
#include "islands/stack_shapes.h"

namespace abflat {
namespace {

Status cancelled() { return {StatusCode::Aborted, "cancelled"}; }

/// All stacks stay that have none of these islands; without islands, none does.
Status holdOthers(const std::vector<std::uint32_t>& islands, MeshLayout& layout) {
  if (islands.empty()) return {};
  for (IslandStack& stack : layout.stacks) stack.isFixed = true;
  for (const std::uint32_t island : islands) {
    if (island >= layout.stackOfIsland.size())
      return {StatusCode::InvalidOption,
              "island " + std::to_string(island) + " cannot be packed: there is none"};
    layout.stacks[layout.stackOfIsland[island]].isFixed = false;
  }
  return {};
}

/// Where some islands stay, all were made for a texture of this shape.
void setAspects(const PolygonMesh& mesh, const PackLayoutOptions& options, MeshLayout& layout) {
  if (options.keepPlaces) return;
  const double aspect = options.resolution.aspect();
  const double old = options.islands.empty() ? oldAspect(mesh, layout.triangles, aspect) : aspect;
  for (IslandStack& stack : layout.stacks) stack.aspect = stack.isFixed ? 1 : old;
}

Status noTexcoords() {
  return {StatusCode::NoTexcoords,
          "no face has texcoords, so there is no layout to pack. Make one with unwrap"};
}

Status checkInput(const PolygonMesh& mesh, const PackLayoutOptions& options) {
  if (Status s = validateArrays(mesh); !s.ok()) return s;
  if (mesh.faceCount() == 0) return {StatusCode::EmptyMesh, "the mesh has no faces"};
  if (options.udim && options.texelDensity == kAutoTexelDensity && !options.keepPlaces)
    return {StatusCode::InvalidOption, "udim needs a numeric texel density"};
  if (options.udim && !options.tileOfIsland.empty() && !options.keepPlaces)
    return {StatusCode::InvalidOption, "islands whose tiles are given need no udim"};
  if (mesh.faceTexcoords.empty()) return noTexcoords();
  return {};
}

/// All stay where they are, in as many tiles as they are in.
Packing keptPlaces(const MeshLayout& layout, const PackLayoutOptions& options) {
  constexpr double kMostTiles = 8999;  // UDIM 1001 to 9999
  Packing out;
  if (!options.udim) return out;
  for (const IslandStack& stack : layout.stacks) {
    const double column = std::floor(stack.middle(0)), row = std::floor(stack.middle(1));
    const double tiles = 10 * row + column + 1;
    if (column >= 0 && column < 10 && row >= 0 && tiles <= kMostTiles)
      out.tiles = std::max(out.tiles, static_cast<std::uint32_t>(tiles));
  }
  return out;
}

Result<Packing> placesOf(MeshLayout& layout, const PackLayoutOptions& options, ThreadPool& pool,
                         const Listener& listener) {
  if (options.keepPlaces) return keptPlaces(layout, options);
  return packStacks(layout, options, pool, listener);
}

Result<PackLayoutResult> packIslands(const PolygonMesh& mesh, const PackLayoutOptions& options) {
  const Listener listener(options.progress);
  Stopwatch watch;
  if (Status s = checkInput(mesh, options); !s.ok()) return s;
  PackLayoutResult out;
  out.report.options = options;
  out.report.input = inspect(mesh);

  const Listener packing = listener.part(Stage::Pack, 0, 0.9);
  if (!packing.tell()) return cancelled();
  Islands islands = findIslands(mesh);
  if (islands.count == 0) return noTexcoords();
  if (!packing.tell(0.1)) return cancelled();
  // What stays may overlap on purpose.
  const bool byMaterial = !options.keepPlaces && options.islands.empty();
  MeshLayout layout = readLayout(mesh, std::move(islands), byMaterial, packing);
  if (packing.isStopped()) return cancelled();
  if (Status s = holdOthers(options.islands, layout); !s.ok()) return s;
  setAspects(mesh, options, layout);
  ThreadPool pool(usefulThreads(options.threads, layout.triangles.face.size()));
  out.report.threads = pool.threads();
  const Result<Packing> packed = placesOf(layout, options, pool, packing.part(0.3, 1));
  if (!packed.ok()) return packed.status();
  PlacedTexcoords texcoords = placeTexcoords(mesh, layout, packed.value(), options);
  out.report.timings.pack = watch.lap();

  if (!listener.part(Stage::Check, 0.9, 1).tell()) return cancelled();
  out.faults = describeLayout(layout, packed.value(), texcoords, options, out.report);
  out.report.timings.check = watch.lap();
  out.uv = std::move(texcoords.uv);
  out.cornerUv = std::move(texcoords.cornerUv);
  out.islandOfFace = std::move(layout.islandOfFace);
  out.triangleCorners = std::move(layout.triangleCorners);
  return out;
}

}  // namespace

Result<PackLayoutResult> packLayout(const PolygonMesh& mesh, const PackLayoutOptions& options) {
  return guarded([&] { return packIslands(mesh, options); });
}

}  // namespace abflat
