#include "verify/findings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

#include "abflat/pack_layout.h"
#include "base/counted.h"
#include "base/number_text.h"
#include "exact/orientation.h"
#include "islands/judge_faces.h"

namespace abflat {
namespace {

std::string exactText(double x) {
  char chars[kMostDoubleChars];
  return {chars, writeDouble(chars, x)};
}

/// With few digits, as people read them, but enough to tell it from `other`.
std::string shortText(double x, double other = kNotMeasured) {
  constexpr double kMostDigits = 1e12;
  const double size = std::abs(x);
  double per = size >= 100 ? 1 : size >= 10 ? 10 : size >= 1 ? 100 : 10000;
  while (per < kMostDigits && x != other && std::round(x * per) / per == other) per *= 10;
  return exactText(std::round(x * per) / per);
}

class Finder {
 public:
  Finder(const JudgedLayout& layout, const VerifyOptions& options, const VerifyReport& measured)
      : layout_(layout), options_(options), measured_(measured) {}

  std::vector<VerifyFinding> run() {
    findUnmapped();
    findFlipped();
    findEmpty();
    findOverlapping();
    findOutside();
    findNear();
    findAtEdge();
    findThin();
    findDensities();
    findStretched();
    findTotals();
    return std::move(out_);
  }

 private:
  std::uint32_t islandOf(std::uint32_t triangle) const {
    return layout_.islandOfTriangle[triangle];
  }
  std::uint32_t faceOf(std::uint32_t triangle) const { return layout_.triangles.face[triangle]; }
  std::string faceText(std::uint32_t triangle) const {
    return "face " + std::to_string(faceOf(triangle));
  }

  /// One finding for all triangles that `isBad`; `one` and `many` follow the number of faces.
  template <class IsBad>
  void findFaces(VerifyRule rule, const IsBad& isBad, const char* one, const char* many,
                 const char* what) {
    std::vector<std::uint32_t> faces;
    std::set<std::uint32_t> islands;
    for (std::uint32_t t = 0; t < layout_.triangles.face.size(); ++t)
      if (isBad(t)) {
        faces.push_back(faceOf(t));
        islands.insert(islandOf(t));
      }
    if (faces.empty()) return;
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    VerifyFinding found;
    found.rule = rule;
    found.message = counted(faces.size(), one, many) +
                    (faces.size() > 1 ? ", the first of which is face " : ": face ") +
                    std::to_string(faces.front()) + ". " + what;
    takeFirst(std::move(faces), found.faces);
    takeFirst({islands.begin(), islands.end()}, found.islands);
    out_.push_back(std::move(found));
  }

  static void takeFirst(std::vector<std::uint32_t> all, std::vector<std::uint32_t>& out) {
    all.resize(std::min(all.size(), kMostListed));
    out = std::move(all);
  }

  void findUnmapped() {
    const std::vector<std::uint32_t>& faces = layout_.unmapped;
    if (options_.allowUnmapped || faces.empty()) return;
    VerifyFinding found;
    found.rule = VerifyRule::Unmapped;
    found.message = counted(faces.size(), "face has no texcoords", "faces have no texcoords") +
                    (faces.size() > 1 ? ", the first of which is face " : ": face ") +
                    std::to_string(faces.front()) + ". Unwrap the mesh, or allow unmapped faces";
    takeFirst(faces, found.faces);
    out_.push_back(std::move(found));
  }

  bool isFlipped(std::uint32_t t) const {
    const double* uv = &layout_.triangles.inUv.uv[6 * std::size_t{t}];
    const int turn = orientation(uv, uv + 2, uv + 4);
    const bool mayBeMirrored =
        options_.allowMirrored && layout_.measures.islands[islandOf(t)].isMirrored();
    return mayBeMirrored ? turn > 0 : turn < 0;
  }

  void findFlipped() {
    const char* what = options_.allowMirrored
                           ? "The rest of the island runs the other way; unwrap it again"
                           : "Unwrap again, or allow mirrored islands if that is on purpose";
    findFaces(
        VerifyRule::Flipped, [&](std::uint32_t t) { return isFlipped(t); }, "face is turned over",
        "faces are turned over", what);
  }

  void findEmpty() {
    if (options_.allowEmpty) return;
    findFaces(
        VerifyRule::Empty,
        [&](std::uint32_t t) {
          return layout_.measures.hasArea[t] && hasFault(layout_.faults[t], UvFault::Empty);
        },
        "face has no area in uv", "faces have no area in uv", "Unwrap again, or allow empty faces");
  }

  std::string overlapText(const IslandOverlap& pair) const {
    std::string out = pair.isOwn() ? "island " : "islands ";
    out.append(std::to_string(pair.islands[0]));
    if (!pair.isOwn()) out.append(" and ").append(std::to_string(pair.islands[1]));
    out.append(pair.isOwn()     ? " overlaps itself"
               : pair.isStacked ? " cover the same place"
                                : " overlap");
    out.append(", at faces ").append(std::to_string(faceOf(pair.triangles[0])));
    out.append(" and ").append(std::to_string(faceOf(pair.triangles[1])));
    return out.append(pair.isOwn()     ? ". Cut it there"
                      : pair.isStacked ? ". Allow stacked islands if that is on purpose"
                                       : ". Pack the layout again");
  }

  void findOverlapping() {
    if (options_.allowOverlaps) return;
    std::size_t listed = 0;
    for (const IslandOverlap& pair : layout_.overlaps.pairs) {
      if (pair.isStacked && options_.allowStacked) continue;
      if (++listed > kMostListed) return;
      const auto [a, b] = pair.islands;
      const auto [i, k] = pair.triangles;
      VerifyFinding found;
      found.rule = pair.isOwn()     ? VerifyRule::Overlap
                   : pair.isStacked ? VerifyRule::Stacked
                                    : VerifyRule::OverlapBetween;
      found.message = overlapText(pair);
      found.faces = {faceOf(i), faceOf(k)};
      found.islands = pair.isOwn() ? std::vector<std::uint32_t>{a} : std::vector{a, b};
      out_.push_back(std::move(found));
    }
  }

  void findOutside() {
    if (options_.allowOutsideTiles) return;
    findFaces(
        VerifyRule::Outside,
        [&](std::uint32_t t) { return hasFault(layout_.faults[t], UvFault::Outside); },
        "face is not within its tile", "faces are not within their tiles",
        options_.udim ? "Each island has to lie in one tile" : "u and v have to be from 0 to 1");
  }

  /// In texels of the texture.
  double needed(double texels) const { return std::ldexp(texels, options_.mipLevels); }
  std::string askedText(double texels) const {
    const std::string asked = shortText(texels);
    if (options_.mipLevels == 0) return asked + " are asked for";
    return asked + " are asked for in mip level " + std::to_string(options_.mipLevels) +
           ", which are " + shortText(needed(texels)) + " here";
  }

  bool doOverlap(const std::array<std::uint32_t, 2>& islands) const {
    const auto& pairs = layout_.overlaps.pairs;
    const auto at = std::lower_bound(
        pairs.begin(), pairs.end(), islands,
        [](const IslandOverlap& a, const auto& wanted) { return a.islands < wanted; });
    return at != pairs.end() && at->islands == islands;
  }

  void findNear() {
    const double limit = needed(options_.padding);
    if (!(limit > 0) || !(measured_.distanceIslands < limit)) return;
    std::vector<ChartGap> gaps = gapsBelow(layout_.outlines, limit);
    gaps.erase(std::remove_if(gaps.begin(), gaps.end(),
                              [&](const ChartGap& gap) { return doOverlap(gap.charts); }),
               gaps.end());
    std::stable_sort(gaps.begin(), gaps.end(),
                     [](const ChartGap& a, const ChartGap& b) { return a.distance < b.distance; });
    gaps.resize(std::min(gaps.size(), kMostListed));
    for (const ChartGap& gap : gaps) {
      VerifyFinding found;
      found.rule = VerifyRule::Padding;
      for (const std::uint32_t edge : gap.edges)
        found.faces.push_back(faceOf(layout_.outlines.triangle[edge]));
      found.islands = {gap.charts[0], gap.charts[1]};
      found.value = gap.distance;
      found.limit = limit;
      found.message = "islands " + std::to_string(gap.charts[0]) + " and " +
                      std::to_string(gap.charts[1]) + " are " + shortText(gap.distance, limit) +
                      " texels apart, at faces " + std::to_string(found.faces[0]) + " and " +
                      std::to_string(found.faces[1]) + "; " + askedText(options_.padding);
      out_.push_back(std::move(found));
    }
  }

  /// One finding for each island that `isBad`, the worst first.
  template <class ValueOf, class Say>
  void findIslands(VerifyRule rule, double limit, bool isLeast, const ValueOf& valueOf,
                   const Say& say) {
    std::vector<std::pair<double, std::uint32_t>> bad;
    for (std::uint32_t i = 0; i < layout_.measures.islands.size(); ++i) {
      const double value = valueOf(i);
      if (isLeast ? value < limit : value > limit) bad.emplace_back(value, i);
    }
    std::stable_sort(bad.begin(), bad.end(), [&](const auto& a, const auto& b) {
      return isLeast ? a.first < b.first : a.first > b.first;
    });
    bad.resize(std::min(bad.size(), kMostListed));
    for (const auto& [value, island] : bad) {
      VerifyFinding found;
      found.rule = rule;
      const std::uint32_t first = layout_.triangles.inUv.begin[island];
      found.faces = {faceOf(first)};
      found.islands = {island};
      found.value = value;
      found.limit = limit;
      found.message =
          "island " + std::to_string(island) + ", of " + faceText(first) + ", " + say(value);
      out_.push_back(std::move(found));
    }
  }

  void findAtEdge() {
    const double limit = needed(options_.margin);
    if (!(limit > 0)) return;
    findIslands(
        VerifyRule::Margin, limit, true,
        [&](std::uint32_t i) { return layout_.isOutside[i] ? limit : layout_.toEdge[i]; },
        [&](double value) {
          return "is " + shortText(value, limit) + " texels from the edge of its tile; " +
                 askedText(options_.margin);
        });
  }

  void findThin() {
    findIslands(
        VerifyRule::Thin, options_.minIslandWidth, true,
        [&](std::uint32_t i) { return layout_.measures.islands[i].width; },
        [&](double value) {
          return "is " + shortText(value, options_.minIslandWidth) + " texels wide; " +
                 shortText(options_.minIslandWidth) + " are asked for";
        });
  }

  void findDensity(double limit, bool isLeast) {
    if (!(limit > 0)) return;
    const AtTriangle& worst =
        isLeast ? layout_.measures.leastDensity : layout_.measures.mostDensity;
    const auto isBad = [&](double density) { return isLeast ? density < limit : density > limit; };
    if (!isBad(worst.value)) return;
    const std::string asked =
        std::string(isLeast ? "At least " : "At most ") + shortText(limit) + " are asked for";
    findFaces(
        VerifyRule::Density, [&](std::uint32_t t) { return isBad(layout_.measures.densityOf[t]); },
        isLeast ? "face has too few texels" : "face has too many texels",
        isLeast ? "faces have too few texels" : "faces have too many texels", asked.c_str());
    out_.back().value = worst.value;
    out_.back().limit = limit;
    out_.back().message += "; " + faceText(worst.triangle) + " has " +
                           shortText(worst.value, limit) + " texels per unit";
  }

  void findDensities() {
    findDensity(options_.minTexelDensity, true);
    findDensity(options_.maxTexelDensity, false);
    if (options_.maxDensityRatio > 0 && measured_.texelDensityRatio > options_.maxDensityRatio)
      findTotal(VerifyRule::DensityRatio, measured_.texelDensityRatio, options_.maxDensityRatio,
                "an island has " + shortText(measured_.texelDensityRatio) +
                    " times as many texels per unit as another; at most " +
                    shortText(options_.maxDensityRatio) + " times are asked for");
  }

  void findStretched() {
    if (!(options_.maxStretch > 0)) return;
    findIslands(
        VerifyRule::Stretch, options_.maxStretch, false,
        [&](std::uint32_t i) { return layout_.measures.islands[i].stretch; },
        [&](double value) {
          return "has a stretch of " + shortText(value, options_.maxStretch) + "; at most " +
                 exactText(options_.maxStretch) + " is asked for";
        });
  }

  void findTotal(VerifyRule rule, double value, double limit, const std::string& message) {
    VerifyFinding found;
    found.rule = rule;
    found.value = value;
    found.limit = limit;
    found.message = message;
    out_.push_back(std::move(found));
  }

  void findTotals() {
    if (measured_.utilization < options_.minUtilization)
      findTotal(VerifyRule::Utilization, measured_.utilization, options_.minUtilization,
                "islands cover " + shortText(100 * measured_.utilization) + " % of the tiles; " +
                    shortText(100 * options_.minUtilization) + " % are asked for");
    const auto islands = static_cast<double>(measured_.islands);
    if (options_.maxIslands > 0 && islands > options_.maxIslands)
      findTotal(VerifyRule::Islands, islands, options_.maxIslands,
                "there are " + std::to_string(measured_.islands) + " islands; at most " +
                    std::to_string(options_.maxIslands) + " are asked for");
  }

  const JudgedLayout& layout_;
  const VerifyOptions& options_;
  const VerifyReport& measured_;
  std::vector<VerifyFinding> out_;
};

}  // namespace

std::vector<VerifyFinding> findingsOf(const JudgedLayout& layout, const VerifyOptions& options,
                                      const VerifyReport& measured) {
  return Finder(layout, options, measured).run();
}

}  // namespace abflat
