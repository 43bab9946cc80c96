#include "pack/pack.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "pack/scale_search.h"
#include "stopwatch.h"

namespace abflat {
namespace {

/// Coordinates up to 16 (ten tiles in a row) rounded to single precision move by no more.
constexpr double kRounding = 0x1p-20;

std::string number(double x) { return std::to_string(static_cast<long long>(x)); }

Status checkOptions(const PackOptions& o) {
  const auto invalid = [](std::string text) {
    return Status{StatusCode::InvalidOption, std::move(text)};
  };
  if (o.resolution < 1 || o.resolution > 32768)
    return invalid("the resolution is " + number(o.resolution) + "; it must be 1 to 32768 texels");
  if (o.padding < 0 || 2 * ((o.padding + 1) / 2) >= o.resolution)
    return invalid("a padding of " + number(o.padding) + " texels leaves no room in a tile of " +
                   number(o.resolution) + "; lower the padding or raise the resolution");
  if (!(o.texelDensity >= 0) || !std::isfinite(o.texelDensity))
    return invalid("the texel density must be a finite number, 0 or above");
  return {};
}

Status checkShapes(const std::vector<PackShape>& shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (const double x : shapes[i].uv)
      if (!std::isfinite(x))
        return {StatusCode::InvalidMesh,
                "chart " + number(static_cast<double>(i)) +
                    " has a coordinate that is not finite and cannot be packed"};
  return {};
}

PackItem makeItem(const PackShape& shape, int angles) {
  PackItem item;
  item.loops = coveringLoops(shape);
  item.area = areaOf(shape);
  const std::vector<PlanePoint> hull = convexHull(item.loops.points);
  const Pose base = angles > 1 ? leastBoxPose(hull) : turned({}, 0, 1, hull);
  for (int k = 0; k < angles; ++k) item.poses.push_back(turned(base, k, angles, hull));
  item.size = base.width * base.height;
  return item;
}

std::vector<std::uint32_t> largestFirst(const std::vector<PackItem>& items) {
  std::vector<std::uint32_t> order(items.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&items](std::uint32_t a, std::uint32_t b) {
    return items[a].size != items[b].size ? items[a].size > items[b].size : a < b;
  });
  return order;
}

}  // namespace

Result<Packing> pack(const std::vector<PackShape>& shapes, const PackOptions& options) {
  Stopwatch watch;
  if (Status s = checkOptions(options); !s.ok()) return s;
  if (Status s = checkShapes(shapes); !s.ok()) return s;
  const int angles = options.rotate ? 8 : 1;
  std::vector<PackItem> items(shapes.size());
  parallelFor(options.pool, shapes.size(),
              [&](std::size_t i) { items[i] = makeItem(shapes[i], angles); });
  const std::vector<std::uint32_t> order = largestFirst(items);

  PackGrid grid;
  grid.resolution = options.resolution;
  grid.padding = options.padding;
  grid.border = (options.padding + 1) / 2;
  grid.slack = options.resolution * kRounding;
  ScaleSearch found = searchScale(items, order, grid, options.pool, options.progress);
  if (found.best.fit == Fit::Cancelled) return Status{StatusCode::Aborted, "cancelled"};

  Packing out;
  out.tiles = found.best.tiles;
  out.tries = found.tries;
  out.texelDensity = found.texelsPerUnit;
  out.scale = found.texelsPerUnit / options.resolution;
  double area = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Spot& spot = found.best.spots[i];
    const Pose& pose = items[i].poses[spot.pose];
    const PlanePoint origin = texelOrigin(grid, pose, spot, found.texelsPerUnit);
    out.placements.push_back({out.scale * pose.cos, out.scale * pose.sin,
                              origin.x / options.resolution, origin.y / options.resolution,
                              spot.tile});
    area += items[i].area;
  }
  out.utilization = area * out.scale * out.scale / out.tiles;
  out.seconds = watch.lap();
  return out;
}

}  // namespace abflat
