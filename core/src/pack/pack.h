#pragma once

#include <cstdint>
#include <vector>

#include "abflat/generated/unwrap_options.h"
#include "abflat/status.h"
#include "base/listener.h"
#include "base/parallel.h"

namespace abflat {

/// One chart in its own layout.
struct PackShape {
  std::vector<double> uv;                ///< 2 per vertex, in a unit common to all charts, any pose
  std::vector<std::uint32_t> triangles;  ///< 3 vertices per triangle
  /// Vertices of the boundary loop, counter-clockwise. If empty, the outlines of all triangles are
  /// used, which is correct for any set of triangles but slower.
  std::vector<std::uint32_t> outline;
  /// The image of the mesh's up direction, as long as the height gained per length; see levelPose.
  double upU = 0, upV = 0;
  /// What it covers if its triangles overlap; 0: their sum.
  double coveredArea = 0;
  bool isPosed = false;  ///< it lies as it should: turns count from there
  /// The shape stays where it is: its uv are already places in the atlas, and others go around it.
  /// If there are several tiles, it belongs to the one that contains the middle of its box.
  bool isFixed = false;
};

struct PackOptions {
  AtlasSize resolution = 1024;   ///< of a tile
  int padding = 2;               ///< free texels between charts
  int margin = kAutoMargin;      ///< free texels to the edge of the tile; see marginOf
  Rotate rotate = Rotate::Auto;  ///< beyond the pose in which a chart lies level and upright
  double texelDensity = 0;       ///< texels per unit of the mesh; 0: the most that fits one tile
  /// What charts much like these got: the search begins there, and with thousands of charts goes no
  /// higher; 0: unknown.
  double formerDensity = 0;
  double mostDensity = 0;      ///< limits it if `texelDensity` is 0; 0: no limit
  bool fixedMayLeave = false;  ///< fixed shapes may be outside of tiles
  double unit = 1;             ///< length in the mesh's unit of a length of 1 in the charts
  bool udim = false;           ///< with a density: as many tiles as needed, not one
  bool snapToTexels = false;   ///< the box of each level chart has its sides on texel borders
  /// Once all charts have a place, better ones are searched for until this many rows of texels (or
  /// larger cells) have been looked at, over all charts in all poses; 0: until no better one is
  /// found.
  double work = 0;
  ThreadPool* pool = nullptr;
  Listener listener;  ///< once it has stopped, the status is Aborted
};

/// Free texels between charts and the edge of their tile. By default two tiles side by side keep
/// their charts `padding` texels apart.
template <class Options>
int marginOf(const Options& options) {
  return options.margin == kAutoMargin ? (options.padding + 1) / 2 : options.margin;
}

/// The options that calls have in common.
template <class Options>
PackOptions packOptionsOf(const Options& options) {
  PackOptions out;
  out.resolution = options.resolution;
  out.padding = options.padding;
  out.margin = options.margin;
  out.rotate = options.rotate;
  out.texelDensity = options.texelDensity;
  out.udim = options.udim;
  out.snapToTexels = options.snapToTexels;
  return out;
}

/// Where a chart goes: (u, v) -> (stretchU (a u - b v) + x, aspect (stretchV (b u + a v) + y)),
/// inside the unit square of its tile. a and b are the scale times cosine and sine.
struct Placement {
  double a = 1, b = 0;
  double x = 0, y = 0;
  std::uint32_t tile = 0;
  double aspect = 1;                  ///< of the tile; see AtlasSize
  double stretchU = 1, stretchV = 1;  ///< to whole texels

  double u(const double* uv) const { return stretchU * (a * uv[0] - b * uv[1]) + x; }
  double v(const double* uv) const { return (stretchV * (b * uv[0] + a * uv[1]) + y) * aspect; }
  /// Position of the tile in the plane of all tiles: rows of ten, as in UDIM 1001 + tile.
  double column() const { return tile % 10; }
  double row() const { return (tile - tile % 10) / 10.0; }
};

struct Packing {
  double scale = 1;  ///< of all charts that are not fixed: tile widths per unit length
  std::vector<Placement> placements;
  std::uint32_t tiles = 1;
  double utilization = 0;   ///< area of all charts over that of all tiles
  double texelDensity = 0;  ///< texels per unit of the mesh
  double seconds = 0;
  int tries = 0;  ///< number of scales tried
};

/// How much packing may look at, in the unit of PackOptions. It grows with the triangles so that
/// packing takes less time than flattening, but it is enough to pack small meshes well.
double usualWork(const std::vector<PackShape>& shapes);

/// Packs charts into an atlas. No texel (closed unit square of the grid that `resolution` makes of
/// a tile) is touched by two charts, and any two charts have `padding` texels between them in at
/// least one of the two directions. That also holds for coordinates rounded to single precision.
/// Errors: InvalidOption, InvalidMesh, Aborted; AtlasTooSmall says what does fit.
Result<Packing> pack(std::vector<PackShape> shapes, const PackOptions& options);

}  // namespace abflat
