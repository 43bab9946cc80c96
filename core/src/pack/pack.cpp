#include "pack/pack.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include "base/invalid.h"
#include "base/number_text.h"
#include "base/stopwatch.h"
#include "pack/check_packing.h"
#include "pack/level_pose.h"
#include "pack/strategies.h"
#include "pack/tidy_search.h"

namespace abflat {
namespace {

/// UDIM rows of ten, from 1001 to 9999.
constexpr std::uint32_t kMostTiles = 8999;
constexpr double kLastRow = 898;  // that has all ten
constexpr double kLeastScale = 1e-100, kMostScale = 1e100;

Status tooSmall(std::string text) { return {StatusCode::AtlasTooSmall, std::move(text)}; }

template <typename T>
std::string text(T integer) {
  static_assert(std::is_integral_v<T>);
  return std::to_string(integer);
}

/// A positive number, rounded down to three digits.
double roundedDown(double x) {
  int exponent = static_cast<int>(std::floor(std::log10(x))) - 2;
  const auto number = [&](double digits) {
    double out = 0;
    parseDouble(text(static_cast<int>(digits)) + "e" + text(exponent), out);
    return out;
  };
  if (number(100) > x) --exponent;  // the logarithm may be rounded up
  double digits = 1000;
  while (digits > 100 && number(digits) > x) --digits;
  const double out = number(digits);
  return out > 0 && out <= x ? out : x;
}

std::string text(double number) {
  char digits[kMostDoubleChars];
  return {digits, writeDouble(digits, number)};
}

/// ". Do this, do that, or do the other".
std::string choiceOf(const std::vector<std::string>& ways) {
  std::string out;
  for (std::size_t i = 0; i < ways.size(); ++i)
    out += (i == 0 ? ". " : i + 1 < ways.size() ? ", " : ", or ") + ways[i];
  if (!out.empty()) out[2] = static_cast<char>(out[2] - 'a' + 'A');
  return out;
}

/// A size of about the same shape.
AtlasSize withWidth(double width, const AtlasSize& size) {
  return {static_cast<int>(std::ceil(width)), static_cast<int>(std::ceil(width / size.aspect()))};
}

/// The smallest tile of that shape that holds so many single texels with their padding and margin;
/// one that is too large if there is none.
AtlasSize leastResolution(std::size_t count, const PackOptions& options) {
  const auto texels = [&](int side) {
    const int inside = side - 2 * marginOf(options) + options.padding;
    return static_cast<double>(std::max(inside / (options.padding + 1), 0));
  };
  for (int width = 1;; ++width) {
    const AtlasSize size = withWidth(width, options.resolution);
    const bool isEnough = texels(size.width) * texels(size.height) >= static_cast<double>(count);
    if (isEnough || size.longer() > kMostResolution) return size;
  }
}

LevelPose poseOf(const PackShape& shape, const Loops& loops, const std::vector<PlanePoint>& hull) {
  LevelPose out = levelPose(loops, hull, {shape.upU, shape.upV});
  if (!shape.isPosed) return out;
  // One whose straight edges lie askew may be turned like one without.
  constexpr double kAskew = 1e-3;
  out.isStraight = out.isStraight && std::abs(out.pose.sin * out.pose.cos) < kAskew;
  out.pose = turned(Pose(), 0, 4, hull);
  out.isLevel = true;
  return out;
}

/// A single call of pack().
class Packer {
 public:
  explicit Packer(const PackOptions& options) : options_(options) {}

  Result<Packing> run(std::vector<PackShape> shapes) {
    Stopwatch watch;
    if (Status s = checkPackOptions(options_); !s.ok()) return s;
    if (Status s = checkPackShapes(shapes); !s.ok()) return s;
    takeShapes(std::move(shapes));
    if (Status s = begin(); !s.ok()) return s;
    if (Status s = options_.texelDensity > 0 ? placeAtDensity() : placeAsLarge(); !s.ok()) return s;
    Packing out = placements();
    out.seconds = watch.lap();
    return out;
  }

 private:
  void takeShapes(std::vector<PackShape> shapes) {
    fixedTile_.resize(shapes.size());
    for (std::uint32_t i = 0; i < shapes.size(); ++i)
      if (!shapes[i].isFixed) movable_.push_back(i);
    makeItems(shapes);
    for (std::uint32_t i = 0; i < shapes.size(); ++i)
      if (shapes[i].isFixed) fixed_.push_back({i, std::move(shapes[i])});
  }

  Status begin() {
    grid_ = makePackGrid(options_, itemsOfTile());
    return takeFixed();
  }

  /// Sets up the tiles, with the fixed shapes in them.
  Status takeFixed() {
    taken_.assign(1, {});
    PackRaster raster(grid_);
    for (const auto& [i, shape] : fixed_) {
      const Loops loops = coveringLoops(shape);
      Pose box;
      box = turned(box, 0, 4, loops.points);
      const double lastRow = options_.udim ? kLastRow : 0;
      const double lastColumn = options_.udim ? 9 : 0;
      double column = std::floor(box.minX + box.width / 2);
      double row = std::floor(box.minY + box.height / 2);
      const bool isInside = box.minX >= column && box.minX + box.width <= column + 1 &&
                            box.minY >= row && box.minY + box.height <= row + 1;
      const bool exists = column >= 0 && column <= lastColumn && row >= 0 && row <= lastRow;
      if (options_.fixedMayLeave) {
        column = std::clamp(column, 0.0, lastColumn);
        row = std::clamp(row, 0.0, lastRow);
      } else if (!isInside || !exists)
        return invalid("chart " + text(i) +
                       " is fixed, but lies outside the unit square of its tile");
      const auto tile = static_cast<std::uint32_t>(row * 10 + column);
      if (taken_.size() <= tile) taken_.resize(tile + 1);
      add(raster.takenInTile(loops, column, row), taken_[tile]);
      fixedTile_[i] = tile;
    }
    return {};
  }

  /// Does not keep the shapes, since there may be as many as triangles.
  void makeItems(std::vector<PackShape>& shapes) {
    items_.resize(movable_.size());
    const int poses = posesFor(movable_.size(), options_.rotate);
    // Where there are many charts, angles other than quarters gain little.
    const bool isFree = poses > 4;
    parallelFor(options_.pool, items_.size(), [&, poses, isFree](std::size_t i) {
      const PackShape shape = std::move(shapes[movable_[i]]);
      PackItem& item = items_[i];
      item.loops = coveringLoops(shape);
      item.mass = massOf(shape);
      if (shape.coveredArea > 0) item.mass.area = shape.coveredArea;
      const std::vector<PlanePoint> hull = convexHull(item.loops.points);
      const LevelPose level = poseOf(shape, item.loops, hull);
      item.isLevel = level.isLevel;
      item.isUpright = level.isUpright;
      item.poses = Poses(isFree ? leastBoxPose(hull) : level.pose, poses, hull);
      if (isFree) item.poses.addFirst(level.pose, hull);
      if (options_.rotate == Rotate::Auto && level.isStraight) item.poses.hold();
      if (options_.snapToTexels && level.isLevel) item.poses.snap();
    });
  }

  /// Texels per unit length of the charts. Clamped: when no chart reaches a texel, or one exceeds
  /// any tile, the exact value makes no difference.
  double scaleOf(double density) const {
    return std::clamp(density * options_.unit, kLeastScale, kMostScale);
  }

  /// The inverse of scaleOf().
  double densityOf(double scale) const {
    return std::min(scale / options_.unit, std::numeric_limits<double>::max());
  }

  /// Rough number of items that will share a tile.
  std::size_t itemsOfTile() const {
    double texels = 0;
    for (const PackItem& item : items_)
      texels += item.mass.area * scaleOf(options_.texelDensity) * scaleOf(options_.texelDensity);
    const double tiles = texels / options_.resolution.width / options_.resolution.height;
    const auto count = static_cast<double>(items_.size());
    return static_cast<std::size_t>(std::ceil(count / std::max(tiles, 1.0)));
  }

  /// In one tile, as large as allowed.
  Status placeAsLarge() {
    if (options_.mostDensity > 0) {
      density_ = scaleOf(options_.mostDensity);
      tryAt(density_);
      if (placed_.fit == Fit::Cancelled) return {StatusCode::Aborted, "cancelled"};
      if (placed_.fit == Fit::All) return {};
    }
    return placeInOneTile();
  }

  Status placeInOneTile() {
    search();
    if (placed_.fit == Fit::Cancelled) return {StatusCode::Aborted, "cancelled"};
    if (placed_.fit == Fit::All) return {};
    if (grid_.cell > 1) {
      grid_.cell = 1;
      if (Status s = takeFixed(); !s.ok()) return s;
      return placeInOneTile();
    }
    return tooSmall(text(movable_.size()) + " charts of one texel each, with a padding of " +
                    text(options_.padding) + ", do not fit a tile of " +
                    atlasSizeText(options_.resolution) + waysForTexels());
  }

  void search() {
    const double former = options_.formerDensity > 0 ? scaleOf(options_.formerDensity) : 0;
    const ScaleOptions how{options_.work, former, options_.pool, options_.listener};
    ScaleSearch found = options_.rotate == Rotate::Auto
                            ? searchTidyScale(items_, grid_, taken_[0], how)
                            : searchScale(items_, grid_, taken_[0], how);
    tries_ = found.tries;
    density_ = found.texelsPerUnit;
    placed_ = std::move(found.best);
  }

  std::string waysForTexels() const {
    const AtlasSize least = leastResolution(movable_.size(), options_);
    if (options_.resolution.width >= least.width)
      return " beside the fixed ones. Raise the resolution";
    std::vector<std::string> ways;
    if (least.longer() <= kMostResolution)
      ways.push_back("raise the resolution to " + atlasSizeText(least) + " or more");
    if (options_.padding > 0) ways.push_back("lower the padding");
    if (options_.margin > 0) ways.push_back("lower the margin");
    return choiceOf(ways);
  }

  Status placeAtDensity() {
    density_ = scaleOf(options_.texelDensity);
    tryAt(density_);
    if (placed_.fit == Fit::TooMany)
      return options_.udim ? largestIsTooLarge() : doesNotFitOneTile();
    return placed_.fit == Fit::All ? Status{} : Status{StatusCode::Aborted, "cancelled"};
  }

  /// Sets `placed_`. In a single tile every strategy gets its turn.
  void tryAt(double density) {
    PlaceOptions options;
    options.texelsPerUnit = density;
    options.mostTiles = options_.udim ? kMostTiles : 1;
    options.listener = options_.listener;
    PlaceSpace space;
    for (const double tidiness : {kTidiest, 0.0})
      for (const PlaceStrategy& strategy : strategiesFor(items_, tidiness)) {
        placed_ = place(items_, strategy, grid_, taken_, options, space);
        ++tries_;
        if (placed_.fit != Fit::TooMany || options_.udim) return;
      }
  }

  Status largestIsTooLarge() const {
    const int around = std::max(options_.padding, 2 * options_.margin);
    const double width = std::max(options_.resolution.width - around, 1);
    const double most =
        scaleForAll(items_, width, std::max(options_.resolution.height - around, 1));
    return doesNotFit("chart " + text(movable_[placed_.missing]) + " does not fit a tile",
                      density_ / most * width + around, densityOf(most));
  }

  Status doesNotFitOneTile() {
    const double wanted = density_;
    if (Status s = placeInOneTile(); !s.ok()) return s;
    return doesNotFit("the charts do not fit one tile",
                      options_.resolution.width * (wanted / density_), densityOf(density_));
  }

  /// Says what has been tried and what does fit; `width` and `density` refer to the latter.
  Status doesNotFit(const std::string& what, double width, double density) const {
    const double coarser = densityThatFits(density);
    if (coarser == 0) return {StatusCode::Aborted, "cancelled"};
    const AtlasSize finer = resolutionThatFits(width);
    std::vector<std::string> ways = {"lower the density to " + text(coarser)};
    if (finer.width > 0) ways.push_back("raise the resolution to " + atlasSizeText(finer));
    if (!options_.udim) ways.emplace_back("allow several tiles");
    return tooSmall("at " + text(options_.texelDensity) + " texels per unit " + what + " of " +
                    atlasSizeText(options_.resolution) + " texels" + choiceOf(ways));
  }

  /// The first density from this one down that fits; 0 if cancelled.
  double densityThatFits(double from) const {
    PackOptions coarser = options_;
    for (double density = roundedDown(std::min(from, options_.texelDensity));;
         density = roundedDown(0.99 * density)) {
      coarser.texelDensity = density;
      const Fit fit = fitOf(coarser);
      if (fit != Fit::TooMany) return fit == Fit::All ? density : 0;
    }
  }

  /// The first resolution from this width up that fits; 0 if there is none, or if cancelled.
  AtlasSize resolutionThatFits(double width) const {
    PackOptions finer = options_;
    while (width <= kMostResolution) {
      finer.resolution = withWidth(width, options_.resolution);
      if (finer.resolution.longer() > kMostResolution) break;
      const Fit fit = fitOf(finer);
      if (fit != Fit::TooMany) return fit == Fit::All ? finer.resolution : AtlasSize();
      width *= 1.02;
    }
    return {};
  }

  Fit fitOf(const PackOptions& options) const {
    Packer other = *this;
    other.options_ = options;
    if (!other.begin().ok()) return Fit::TooMany;
    other.tryAt(scaleOf(options.texelDensity));
    return other.placed_.fit;
  }

  Packing placements() const {
    Packing out;
    const double width = options_.resolution.width, aspect = options_.resolution.aspect();
    out.tiles = std::max(placed_.tiles, static_cast<std::uint32_t>(taken_.size()));
    out.tries = tries_;
    out.texelDensity = options_.texelDensity > 0 ? options_.texelDensity : densityOf(density_);
    out.scale = density_ / width;
    out.placements.resize(fixedTile_.size());
    double area = 0;
    for (const auto& [i, shape] : fixed_) {
      const std::uint32_t tile = fixedTile_[i];
      out.placements[i].tile = tile;
      out.placements[i].x = -out.placements[i].column();
      out.placements[i].y = -out.placements[i].row();
      area += massOf(shape).area;
    }
    for (std::size_t k = 0; k < items_.size(); ++k) {
      const Spot& spot = placed_.spots[k];
      Placement& p = out.placements[movable_[k]];
      const double ownArea = items_[k].mass.area * out.scale * out.scale * aspect;
      if (items_[k].loops.points.empty()) {
        area += ownArea;
        continue;
      }
      const Pose pose = items_[k].poses[spot.pose];
      const PlanePoint scale = texelScale(grid_, pose, density_);
      const PlanePoint origin = texelOrigin(grid_, pose, density_, spot.cell.x, spot.cell.y);
      p = {out.scale * pose.cos,
           out.scale * pose.sin,
           origin.x / width,
           origin.y / width,
           spot.tile,
           aspect,
           scale.x / density_,
           scale.y / density_};
      area += ownArea * p.stretchU * p.stretchV;
    }
    out.utilization = area / out.tiles;
    return out;
  }

  struct FixedShape {
    std::uint32_t index;
    PackShape shape;
  };

  PackOptions options_;
  std::vector<FixedShape> fixed_;
  PackGrid grid_;
  std::vector<std::uint32_t> movable_;    ///< shape of each item
  std::vector<std::uint32_t> fixedTile_;  ///< per shape
  std::vector<BitGrid> taken_;            ///< per tile, cells of fixed shapes; may be empty
  std::vector<PackItem> items_;
  Placed placed_;
  double density_ = 0;  ///< texels per unit length of the charts
  int tries_ = 0;
};

}  // namespace

double usualWork(const std::vector<PackShape>& shapes) {
  constexpr double kWorkOfCorner = 10, kLeastWork = 100000;
  double corners = 0;
  for (const PackShape& shape : shapes) corners += static_cast<double>(shape.triangles.size());
  return std::max(kWorkOfCorner * corners, kLeastWork);
}

Result<Packing> pack(std::vector<PackShape> shapes, const PackOptions& options) {
  return Packer(options).run(std::move(shapes));
}

}  // namespace abflat
