#include "islands/pack_stacks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace abflat {
namespace {

constexpr std::uint32_t kTileNumbers = 8999;  // UDIM 1001 to 9999

using StacksByTile = std::map<std::uint32_t, std::vector<std::uint32_t>>;

Status checkTiles(const std::vector<std::uint32_t>& tileOfIsland, std::size_t islands) {
  if (tileOfIsland.empty()) return {};
  if (tileOfIsland.size() != islands)
    return {StatusCode::InvalidOption, "there are tiles for " +
                                           std::to_string(tileOfIsland.size()) + " islands, not " +
                                           std::to_string(islands)};
  for (const std::uint32_t tile : tileOfIsland)
    if (tile >= kTileNumbers)
      return {StatusCode::InvalidOption, "there is no tile " + std::to_string(tile)};
  return {};
}

/// A stack goes to the tile of its first island.
StacksByTile stacksByTile(const std::vector<IslandStack>& stacks,
                          const std::vector<std::uint32_t>& tileOfIsland) {
  StacksByTile out;
  for (std::uint32_t s = 0; s < stacks.size(); ++s)
    out[tileOfIsland.empty() ? 0 : tileOfIsland[stacks[s].islands.front()]].push_back(s);
  return out;
}

/// What stays is where it is, in whatever tile.
PackShape inTile(PackShape shape, std::uint32_t tile) {
  if (!shape.isFixed) return shape;
  Placement p;
  p.tile = tile;
  for (std::size_t i = 0; i < shape.uv.size(); i += 2) {
    shape.uv[i] -= p.column();
    shape.uv[i + 1] -= p.row();
  }
  return shape;
}

/// Packs stacks by tile, one after the other.
class TilePacker {
 public:
  TilePacker(const MeshLayout& layout, const PackOptions& how) : layout_(layout), how_(how) {
    out_.placements.resize(layout.stacks.size());
    out_.tiles = 0;
  }

  Status packTile(std::uint32_t tile, const std::vector<std::uint32_t>& stacks,
                  const Listener& listener) {
    std::vector<PackShape> shapes;
    shapes.reserve(stacks.size());
    for (const std::uint32_t s : stacks) {
      shapes.push_back(inTile(shapeOf(layout_.stacks[s], layout_.triangles.inUv), tile));
      if (!listener.beat(shapes.back().triangles.size())) return {StatusCode::Aborted, "cancelled"};
    }
    PackOptions how = how_;
    how.work = usualWork(shapes);
    how.listener = listener;
    const Result<Packing> packed = pack(std::move(shapes), how);
    if (!packed.ok()) return packed.status();
    take(packed.value(), tile, stacks);
    return {};
  }

  Packing packing(std::size_t tiles) {
    out_.utilization /= static_cast<double>(tiles);
    return std::move(out_);
  }

 private:
  void take(const Packing& packed, std::uint32_t tile, const std::vector<std::uint32_t>& stacks) {
    for (std::size_t k = 0; k < stacks.size(); ++k) {
      out_.placements[stacks[k]] = packed.placements[k];
      out_.placements[stacks[k]].tile += tile;
    }
    out_.tiles = std::max(out_.tiles, tile + packed.tiles);
    out_.utilization += packed.utilization;
    out_.scale = packed.scale;
    out_.texelDensity = packed.texelDensity;
  }

  const MeshLayout& layout_;
  PackOptions how_;
  Packing out_;
};

}  // namespace

Result<Packing> packStacks(MeshLayout& layout, const PackLayoutOptions& options, ThreadPool& pool,
                           const Listener& listener) {
  if (Status s = checkTiles(options.tileOfIsland, layout.stackOfIsland.size()); !s.ok()) return s;
  const double factor = setFactors(options.islandSizes, layout.stacks);
  pool.listen(listener);
  PackOptions how = packOptionsOf(options);
  how.unit = std::ldexp(1.0, layout.exponent);
  how.pool = &pool;
  how.fixedMayLeave = true;
  if (!options.islands.empty()) how.mostDensity = options.resolution.width / factor / how.unit;
  const StacksByTile byTile = stacksByTile(layout.stacks, options.tileOfIsland);
  TilePacker packer(layout, how);
  double done = 0;
  const auto tiles = static_cast<double>(byTile.size());
  for (const auto& [tile, stacks] : byTile) {
    const Listener part = listener.part(done / tiles, (done + 1) / tiles);
    if (Status s = packer.packTile(tile, stacks, part); !s.ok()) return s;
    ++done;
  }
  return packer.packing(byTile.size());
}

}  // namespace abflat
