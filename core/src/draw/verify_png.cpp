#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <set>

#include "abflat/draw.h"
#include "abflat/pack_layout.h"
#include "base/guarded.h"
#include "draw/colours.h"
#include "draw/layout_painter.h"
#include "draw/theme.h"
#include "islands/judge_faces.h"
#include "verify/findings.h"

namespace abflat {
namespace {

/// Along a side; a texel is a pixel if there are no more.
constexpr int kMostPixels = 2048;

/// What is drawn of a triangle, the worst first.
enum class Shade : std::uint8_t { Overlapping, Flipped, Empty, Outside, Found, Good };

Rgb colourOf(Shade shade) {
  switch (shade) {
    case Shade::Overlapping:
      return parseColour("#d55e00");
    case Shade::Flipped:
      return parseColour("#0072b2");
    case Shade::Empty:
      return parseColour(kBad);
    case Shade::Outside:
      return parseColour("#f0e442");
    case Shade::Found:
      return parseColour("#cc79a7");
    case Shade::Good:
      break;
  }
  return parseColour("#dfe5ec");
}

/// The first texcoord at each place, so that edges meet which only have different numbers.
std::vector<std::uint32_t> byPlace(const PolygonMesh& mesh) {
  const auto place = [&](std::uint32_t t) {
    return std::array{mesh.texcoords[2 * std::size_t{t}], mesh.texcoords[2 * std::size_t{t} + 1]};
  };
  std::vector<std::uint32_t> order(mesh.texcoords.size() / 2), first(order.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] =
        i > 0 && place(order[i]) == place(order[i - 1]) ? first[order[i - 1]] : order[i];
  std::vector<std::uint32_t> out;
  for (const std::uint32_t t : mesh.faceTexcoords) out.push_back(t == kNoTexcoord ? t : first[t]);
  return out;
}

class FaultPicture {
 public:
  FaultPicture(const PolygonMesh& mesh, const VerifyResult& result)
      : mesh_(mesh), result_(result), cornerUv_(byPlace(mesh)) {
    for (auto& islands : found_) islands.assign(result.report.islands, 0);
    for (const VerifyFinding& found : result.report.findings) note(found);
    takeTriangles();
    takeFaces();
    chooseFrame();
  }

  Result<std::string> png() {
    const std::vector<PixelPoint> rings = marks();  // of the areas, which the layout takes
    const PaintedLayout layout{mesh_.texcoords, cornerUv_, std::move(areas_),
                               atlasEdges(faces_, cornerUv_), rings};
    PaintOptions options;
    options.colourOf = [&](std::uint32_t i) { return abflat::colourOf(shades_[i]); };
    return paintLayout(layout, frame_, options);
  }

 private:
  /// A list of islands that is full may not have all of them.
  void note(const VerifyFinding& found) {
    const Shade shade = shadeOf(found.rule);
    std::vector<std::uint8_t>& islands = found_[static_cast<std::size_t>(shade)];
    if (found.islands.size() >= kMostListed) islands.assign(islands.size(), 1);
    for (const std::uint32_t i : found.islands) islands[i] = 1;
  }

  static Shade shadeOf(VerifyRule rule) {
    switch (rule) {
      case VerifyRule::Overlap:
      case VerifyRule::OverlapBetween:
      case VerifyRule::Stacked:
        return Shade::Overlapping;
      case VerifyRule::Flipped:
        return Shade::Flipped;
      case VerifyRule::Empty:
        return Shade::Empty;
      case VerifyRule::Outside:
        return Shade::Outside;
      default:
        return isOfIslands(rule) ? Shade::Found : Shade::Good;
    }
  }

  /// Those that each island keeps to or not, and not each face.
  static bool isOfIslands(VerifyRule rule) {
    return rule == VerifyRule::Padding || rule == VerifyRule::Margin || rule == VerifyRule::Thin ||
           rule == VerifyRule::Stretch;
  }

  void takeTriangles() {
    const std::vector<std::uint32_t>& corners = result_.triangleCorners;
    std::uint32_t face = 0;
    for (std::size_t t = 0; 3 * t < corners.size(); ++t) {
      while (mesh_.faceOffsets[face + 1] <= corners[3 * t]) ++face;
      const std::uint32_t island = result_.islandOfFace[face];
      if (island == kNoIsland) continue;
      areas_.corners.insert(areas_.corners.end(),
                            {corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]});
      areas_.offsets.push_back(static_cast<std::uint32_t>(areas_.corners.size()));
      areas_.face.push_back(face);
      shades_.push_back(shadeOf(result_.faults[t], island));
      isFaulty_.push_back(shades_.back() != Shade::Good && shades_.back() != Shade::Found);
    }
  }

  /// What is allowed is not found, and not shown.
  Shade shadeOf(unsigned faults, std::uint32_t island) const {
    const auto isFound = [&](Shade shade) {
      return found_[static_cast<std::size_t>(shade)][island] != 0;
    };
    const auto isShown = [&](Shade shade, UvFault fault) {
      return isFound(shade) && hasFault(faults, fault);
    };
    if (isShown(Shade::Overlapping, UvFault::Overlapping)) return Shade::Overlapping;
    if (isShown(Shade::Flipped, UvFault::Flipped)) return Shade::Flipped;
    if (isShown(Shade::Empty, UvFault::Empty)) return Shade::Empty;
    if (isShown(Shade::Outside, UvFault::Outside)) return Shade::Outside;
    return isFound(Shade::Found) ? Shade::Found : Shade::Good;
  }

  void takeFaces() {
    for (std::uint32_t f = 0; f < mesh_.faceCount(); ++f) {
      if (result_.islandOfFace[f] == kNoIsland) continue;
      for (std::uint32_t c = mesh_.faceOffsets[f]; c < mesh_.faceOffsets[f + 1]; ++c)
        faces_.corners.push_back(c);
      faces_.offsets.push_back(static_cast<std::uint32_t>(faces_.corners.size()));
      faces_.face.push_back(f);
    }
  }

  const double* uvOf(std::uint32_t corner) const {
    return &mesh_.texcoords[2 * std::size_t{mesh_.faceTexcoords[corner]}];
  }

  /// The first tile, and all that lies outside of it.
  void chooseFrame() {
    double low[2] = {0, 0}, high[2] = {1, 1};
    for (const std::uint32_t c : areas_.corners)
      for (std::size_t d = 0; d < 2; ++d) {
        low[d] = std::min(low[d], uvOf(c)[d]);
        high[d] = std::max(high[d], uvOf(c)[d]);
      }
    const AtlasSize& size = result_.report.options.resolution;
    const double across = (high[0] - low[0]) * size.width, up = (high[1] - low[1]) * size.height;
    const double scale = std::min(1.0, kMostPixels / std::max(across, up));
    frame_.perU = scale * size.width;
    frame_.perV = scale * size.height;
    frame_.left = low[0];
    frame_.top = high[1];
    frame_.width = std::max(1, static_cast<int>(std::lround(across * scale)));
    frame_.height = std::max(1, static_cast<int>(std::lround(up * scale)));
  }

  using Part = std::array<int, 2>;

  /// Faults too small to be seen get a ring: one in each part of the picture that has no larger
  /// one.
  std::vector<PixelPoint> marks() const {
    constexpr double kSmall = 12;  // pixels
    std::vector<PixelPoint> small;
    std::set<Part> taken;
    for (std::uint32_t i = 0; i < shades_.size(); ++i) {
      if (isFaulty_[i] == 0) continue;
      const PixelPoint a = pixelOf(3 * i), b = pixelOf(3 * i + 1), c = pixelOf(3 * i + 2);
      const PixelPoint low = {std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
      const PixelPoint high = {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
      if (std::min(high.x - low.x, high.y - low.y) <= kSmall)
        small.push_back({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
      else
        takeParts(partOf(low), partOf(high), taken);
    }
    std::vector<PixelPoint> out;
    for (const PixelPoint& place : small)
      if (taken.insert(partOf(place)).second) out.push_back(place);
    return out;
  }

  static void takeParts(const Part& low, const Part& high, std::set<Part>& taken) {
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y) taken.insert({x, y});
  }

  static Part partOf(const PixelPoint& place) {
    constexpr double kPart = 28;  // pixels
    return {static_cast<int>(std::floor(place.x / kPart)),
            static_cast<int>(std::floor(place.y / kPart))};
  }

  /// Of a corner of a triangle.
  PixelPoint pixelOf(std::uint32_t corner) const { return frame_.at(uvOf(areas_.corners[corner])); }

  const PolygonMesh& mesh_;
  const VerifyResult& result_;
  std::vector<std::uint32_t> cornerUv_;
  std::array<std::vector<std::uint8_t>, 6> found_;  ///< per shade and island
  AtlasPolygons areas_, faces_;
  std::vector<Shade> shades_;           ///< per triangle that is drawn
  std::vector<std::uint8_t> isFaulty_;  ///< likewise: by itself
  PictureFrame frame_;
};

}  // namespace

Result<std::string> verifyPng(const PolygonMesh& mesh, const VerifyResult& result) {
  return guarded([&] { return FaultPicture(mesh, result).png(); });
}

}  // namespace abflat
