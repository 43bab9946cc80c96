#include "pack/level_pose.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/constants.h"
#include "base/portable_math.h"
#include "base/stable_order.h"

namespace abflat {
namespace {

constexpr double kDegree = kPi / 180, kQuarter = 90 * kDegree;
/// Angles, shares and lengths relative to each other are alike up to this much, so that rounding
/// decides nothing.
constexpr double kAlikeBearing = 1e-9;
/// Edges within that of a direction are straight along it.
constexpr double kStraight = kDegree + kAlikeBearing;
/// Fewer edges than this share make no direction.
constexpr double kLeastOfOutline = 0.1;
/// A shape that gains less height per length lies flat: the sine of 15 degrees.
constexpr double kLeastSlope = 0.2588;

/// The direction of edges modulo quarter turns, and their length as a share of all edges.
struct Bearing {
  double angle = 0, share = 0;
};

/// Just below a quarter turn is as good as 0.
double wrapped(double angle) {
  const double out = angle - kQuarter * std::floor(angle / kQuarter);
  return out < kQuarter - kAlikeBearing ? out : 0;
}

std::vector<Bearing> bearingsOf(const Loops& loops) {
  std::vector<Bearing> out;
  out.reserve(loops.points.size());
  double all = 0;
  std::size_t begin = 0;
  for (const std::uint32_t end : loops.ends) {
    for (std::size_t i = begin; i < end; ++i) {
      const PlanePoint a = loops.points[i], b = loops.points[i + 1 < end ? i + 1 : begin];
      const double length = distance(a, b);
      if (!(length > 0)) continue;
      out.push_back({wrapped(portable::atan2(b.y - a.y, b.x - a.x)), length});
      all += length;
    }
    begin = end;
  }
  for (Bearing& bearing : out) bearing.share /= all;
  sortStably(out, [](const Bearing& a, const Bearing& b) { return a.angle < b.angle; });
  return out;
}

/// Bearing `i`, counted on past the last one by quarter turns.
Bearing bearingAt(const std::vector<Bearing>& bearings, std::size_t i) {
  const Bearing& bearing = bearings[i % bearings.size()];
  const std::size_t quarters = i / bearings.size();
  return {bearing.angle + kQuarter * static_cast<double>(quarters), bearing.share};
}

/// The direction with half of the length of these edges at either side, or the middle between two.
double middleOf(const std::vector<Bearing>& bearings, std::size_t from, std::size_t to,
                double share) {
  double sum = 0, first = -1;
  for (std::size_t i = from; i < to; ++i) {
    sum += bearingAt(bearings, i).share;
    if (first >= 0) return (first + bearingAt(bearings, i).angle) / 2;
    if (sum > (0.5 + kAlikeBearing) * share) return bearingAt(bearings, i).angle;
    if (sum >= (0.5 - kAlikeBearing) * share) first = bearingAt(bearings, i).angle;
  }
  return first;
}

/// The directions that many edges have, most first; of windows with as many, the narrowest.
std::vector<Bearing> straightBearings(std::vector<Bearing> bearings) {
  std::vector<Bearing> out;
  while (!bearings.empty()) {
    double sum = 0, best = 0, narrowest = 0;
    std::size_t from = 0, to = 0;
    for (std::size_t i = 0, j = 0; i < bearings.size(); ++i) {
      for (; j < i + bearings.size() &&
             bearingAt(bearings, j).angle <= bearings[i].angle + 2 * kStraight;
           ++j)
        sum += bearingAt(bearings, j).share;
      const double width = bearingAt(bearings, j - 1).angle - bearings[i].angle;
      const bool isAlike = sum > best - kAlikeBearing && width < narrowest - kAlikeBearing;
      if (sum > best + kAlikeBearing || isAlike) {
        best = sum;
        narrowest = width;
        from = i;
        to = j;
      }
      sum -= bearings[i].share;
    }
    if (best < kLeastOfOutline - kAlikeBearing) break;
    out.push_back({middleOf(bearings, from, to, best), best});
    std::vector<Bearing> others;
    for (std::size_t i = 0; i < bearings.size(); ++i)
      if ((i < from || i >= to) && i + bearings.size() >= to) others.push_back(bearings[i]);
    bearings = std::move(others);
  }
  return out;
}

/// Whether these are the same direction modulo quarter turns, for the eye.
bool isAlong(double angle, double direction) {
  const double from = wrapped(angle - direction);
  return std::min(from, kQuarter - from) <= kStraight;
}

/// Share of the edges along u and v, once the direction lies along u.
double shareAlong(const std::vector<Bearing>& bearings, double direction) {
  double share = 0;
  for (const Bearing& bearing : bearings)
    if (isAlong(bearing.angle, direction)) share += bearing.share;
  return share;
}

/// Adds the direction of `up`, unless edges have it, which then lie exactly level and upright.
void addUpright(const std::vector<Bearing>& bearings, double up, std::vector<Bearing>& directions) {
  const auto isUpright = [&](const Bearing& each) { return isAlong(each.angle, up); };
  if (std::none_of(directions.begin(), directions.end(), isUpright))
    directions.push_back({up, shareAlong(bearings, up)});
}

/// What is compared in turn: differences that rounding could make do not count.
struct Candidate {
  Pose pose;
  double worth = 0;
  PlanePoint center;  ///< of the mass, seen from the middle of the box
};

bool isBetter(const Candidate& a, const Candidate& b) {
  constexpr double kAlike = 1e-6;
  if (std::abs(a.worth - b.worth) > kAlike) return a.worth > b.worth;
  const double size = kAlike * (a.pose.width + a.pose.height);
  const double areas[] = {a.pose.width * a.pose.height, b.pose.width * b.pose.height};
  if (std::abs(areas[0] - areas[1]) > kAlike * areas[0]) return areas[0] < areas[1];
  if (std::abs(a.pose.width - b.pose.width) > size) return a.pose.width > b.pose.width;
  if (std::abs(a.center.x - b.center.x) > size) return a.center.x < b.center.x;
  return a.center.y < b.center.y - size;
}

}  // namespace

LevelPose levelPose(const Loops& loops, const std::vector<PlanePoint>& hull, PlanePoint up) {
  constexpr double kMost = 0.5;
  constexpr double kUpWorth = 0.5;    // of standing upright, where the worth of level edges is 1
  constexpr double kAgreeing = 0.15;  // of edges that are level where the shape stands upright
  LevelPose out;
  const double slope = std::sqrt(up.x * up.x + up.y * up.y);
  out.isUpright = slope > kLeastSlope && std::isfinite(slope);
  const double worth = out.isUpright ? kUpWorth * std::min(slope, 1.0) / slope : 0;
  const std::vector<Bearing> bearings = bearingsOf(loops);
  std::vector<Bearing> directions = straightBearings(bearings);
  if (hull.size() < 2 || (directions.empty() && !out.isUpright))
    return {leastBoxPose(hull), false, false, false};
  const double upright = out.isUpright ? wrapped(portable::atan2(up.y, up.x)) : 0;
  if (out.isUpright) addUpright(bearings, upright, directions);
  const PlanePoint mass = massOf(hull).center;
  std::optional<Candidate> best;
  for (const Bearing& direction : directions) {
    const portable::SinCos by = portable::sinCos(direction.angle);
    Pose level;
    level.cos = by.cos;
    level.sin = -by.sin;
    const bool agrees = out.isUpright && direction.share >= kLeastOfOutline - kAlikeBearing &&
                        isAlong(direction.angle, upright);
    for (int quarter = 0; quarter < 4; ++quarter) {
      Candidate now;
      now.pose = turned(level, quarter, 4, hull);
      const PlanePoint center = now.pose.rotated(mass);
      now.center = {center.x - now.pose.minX - now.pose.width / 2,
                    center.y - now.pose.minY - now.pose.height / 2};
      now.worth = direction.share + worth * now.pose.rotated(up).y + (agrees ? kAgreeing : 0);
      if (best && !isBetter(now, *best)) continue;
      best = now;
      out.isLevel = direction.share > 0;
      out.isStraight = direction.share >= kMost - kAlikeBearing;
    }
  }
  out.pose = best->pose;
  return out;
}

}  // namespace abflat
