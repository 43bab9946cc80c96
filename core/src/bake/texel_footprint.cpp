#include "bake/texel_footprint.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"

namespace abflat {
namespace {

constexpr double kMostProbes = 8;
/// Footprints this much longer than wide are as good as round.
constexpr double kRound = 1.2;
/// Longer ones, in texels, cover more than any texture has.
constexpr double kLongest = 1e9;
/// Shares of a level that cannot be seen.
constexpr double kNoShare = 1e-3;
/// With more probes than this one level is enough, of texels at most this much (as a power of 2)
/// narrower than the footprint.
constexpr int kMostBlended = 2;
constexpr double kNarrower = 0.25;

}  // namespace

TexelFootprint texelFootprint(const Jacobian& j, int reductions) {
  // Singular values, as a sum and a difference.
  const double sum = portable::hypot(j[0] + j[3], j[2] - j[1]) / 2;
  const double difference = portable::hypot(j[0] - j[3], j[2] + j[1]) / 2;
  const double major = sum + difference;
  const double minor = std::max(1.0, std::abs(sum - difference));
  TexelFootprint out;
  if (!(major > 1)) return out;
  const double wanted = std::min(kMostProbes, std::ceil(major / minor - (kRound - 1)));
  out.probes = std::max(1, static_cast<int>(wanted));
  const double width = std::max(minor, major / out.probes);
  if (out.probes > 1) {
    // The eigenvector of J times its transpose, whose eigenvalues are their squares.
    const double xx = j[0] * j[0] + j[1] * j[1], yy = j[2] * j[2] + j[3] * j[3];
    const double xy = j[0] * j[2] + j[1] * j[3];
    const double x = xx > yy ? major * major - yy : xy, y = xx > yy ? xy : major * major - xx;
    const double scale = std::min(major, kLongest) / out.probes / portable::hypot(x, y);
    out.stepX = x * scale;
    out.stepY = y * scale;
    out.firstX = -out.stepX * (out.probes - 1) / 2;
    out.firstY = -out.stepY * (out.probes - 1) / 2;
  }
  double level = portable::log(std::min(width, kLongest)) / portable::log(2);
  if (out.probes > kMostBlended) level = std::ceil(level - kNarrower);
  level = std::min(level, 1.0 * reductions);
  out.level = static_cast<int>(level + kNoShare);
  const double next = level - out.level;
  out.next = next > kNoShare ? static_cast<float>(next) : 0;
  return out;
}

}  // namespace abflat
