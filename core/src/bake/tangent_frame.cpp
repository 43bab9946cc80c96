#include "bake/tangent_frame.h"

#include "mesh/vec3_sum.h"

namespace abflat {
namespace {

Vec3 bitangent(const Vec3& normal, const std::array<double, 4>& tangent) {
  Vec3 out = cross(normal, {tangent[0], tangent[1], tangent[2]});
  for (double& x : out) x *= tangent[3];
  return out;
}

}  // namespace

Colour turnedNormal(const Colour& vector, const TangentFrames& frames) {
  const Vec3 &n = frames.normal, b = bitangent(n, frames.oldTangent);
  Vec3 object{};
  for (std::size_t d = 0; d < 3; ++d)
    object[d] = double{vector.v[0]} * frames.oldTangent[d] + double{vector.v[1]} * b[d] +
                double{vector.v[2]} * n[d];
  // Shares of the new tangent, bitangent and normal, by Cramer's rule.
  const Vec3 newTangent = {frames.tangent[0], frames.tangent[1], frames.tangent[2]};
  const Vec3 newBitangent = bitangent(n, frames.tangent);
  const double volume = dot(newTangent, cross(newBitangent, n));
  Vec3 shares = {dot(object, cross(newBitangent, n)), dot(object, cross(n, newTangent)),
                 dot(object, cross(newTangent, newBitangent))};
  if (volume < 0)
    for (double& x : shares) x = -x;
  shares = unit(shares);
  if (!(volume < 0 || volume > 0) || !(dot(shares, shares) > 0)) return {0, 0, 1, 1};
  return {static_cast<float>(shares[0]), static_cast<float>(shares[1]),
          static_cast<float>(shares[2]), 1};
}

}  // namespace abflat
