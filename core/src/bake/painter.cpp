#include "bake/painter.h"

#include <algorithm>
#include <cmath>

#include "bake/tangent_frame.h"

namespace abflat {
namespace {

/// Coordinates beyond are of no use; their texels can still be counted.
constexpr double kFarthestUv = 1e6;

double within(double coordinate) { return std::clamp(coordinate, -kFarthestUv, kFarthestUv); }

template <std::size_t kCount>
std::array<double, kCount> interpolated(const std::vector<float>& values, std::uint32_t t,
                                        const CornerWeights::Weights& weights) {
  std::array<double, kCount> out{};
  const float* corner = &values[3 * kCount * std::size_t{t}];
  for (const double weight : weights) {
    for (std::size_t d = 0; d < kCount; ++d) out[d] += weight * double{corner[d]};
    corner += kCount;
  }
  return out;
}

/// How often each texture is halved for the triangle that shrinks it most; -1: it is not used.
std::vector<int> reductionsOf(const BakeInput& input, const BandedTriangles& layout,
                              const std::vector<UvTransform>& transforms) {
  std::vector<int> out(input.textures.size(), -1);
  for (std::uint32_t t = 0; t < input.triangles.count(); ++t) {
    const std::uint32_t m = input.triangles.materials[t], texture = input.materials[m].texture;
    const TexelTriangle corners = layout.triangle(t);
    if (texture == kNoTexture || hasNoArea(corners)) continue;
    const ImageView& image = input.textures[texture].image;
    const OldPlace place = oldPlace(&input.triangles.oldUv[6 * std::size_t{t}], transforms[m],
                                    CornerWeights(corners), image);
    const TexelFootprint print = texelFootprint(place.jacobian, mostReductions(image));
    out[texture] = std::max(out[texture], print.level + (print.next > 0 ? 1 : 0));
  }
  return out;
}

}  // namespace

UvTransform::UvTransform(const BakeMaterial& material)
    : scale_(material.scale),
      offset_(material.offset),
      turn_(portable::sinCos(material.rotation)) {}

Point2 UvTransform::at(const double* uv) const {
  const double u = within(uv[0]) * scale_[0], v = within(uv[1]) * scale_[1];
  return {within(turn_.cos * u + turn_.sin * v + offset_[0]),
          within(turn_.cos * v - turn_.sin * u + offset_[1])};
}

OldPlace oldPlace(const double* uv, const UvTransform& transform, const CornerWeights& weights,
                  const ImageView& texture) {
  std::array<Point2, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = transform.at(uv + 2 * k);
    p[k][0] *= texture.width;
    p[k][1] *= texture.height;
  }
  OldPlace out;
  out.first = p[0];
  out.second = {p[1][0] - p[0][0], p[1][1] - p[0][1]};
  out.third = {p[2][0] - p[0][0], p[2][1] - p[0][1]};
  for (std::size_t d = 0; d < 2; ++d)
    for (std::size_t k = 0; k < 2; ++k)
      out.jacobian[2 * d + k] =
          out.second[d] * weights.second()[k] + out.third[d] * weights.third()[k];
  return out;
}

Painter::Painter(const BakeInput& input, MapKind kind, const BandedTriangles& layout,
                 ThreadPool& pool)
    : input_(input),
      kind_(kind),
      transforms_(input.materials.begin(), input.materials.end()),
      samplers_(input.textures.size()) {
  const std::vector<int> reductions = reductionsOf(input, layout, transforms_);
  std::vector<BakeTexture> textures = input.textures;
  for (std::size_t i = 0; i < textures.size(); ++i) {
    if (kind == MapKind::Normal) {
      textures[i].space = ColourSpace::Linear;
      textures[i].alphaIsOpacity = false;
    }
    if (reductions[i] >= 0) codecOf(textures[i]);
  }
  parallelFor(&pool, textures.size(), [&](std::size_t i) {
    if (reductions[i] >= 0)
      samplers_[i] = std::make_unique<Sampler>(textures[i], codecOf(textures[i]), reductions[i]);
  });
}

const Codec& Painter::codecOf(const BakeTexture& texture) {
  const std::size_t isLinear = texture.space == ColourSpace::Linear,
                    isLong = texture.image.bits > 8;
  std::optional<Codec>& codec = codecs_[2 * isLong + isLinear];
  if (!codec) codec.emplace(texture.space, texture.image.bits);
  return *codec;
}

Brush Painter::brush(std::uint32_t t, const TexelTriangle& corners, bool isSpeck) const {
  Brush out{t, corners, CornerWeights(corners), isSpeck};
  const std::uint32_t m = input_.triangles.materials[t];
  out.material = &input_.materials[m];
  if (out.material->texture == kNoTexture) return out;
  out.sampler = samplers_[out.material->texture].get();
  out.place = oldPlace(&input_.triangles.oldUv[6 * std::size_t{t}], transforms_[m], out.weights,
                       input_.textures[out.material->texture].image);
  out.place.first = out.sampler->inFirstPeriod(out.place.first);
  out.footprint = texelFootprint(out.place.jacobian, out.sampler->reductions());
  return out;
}

Colour Painter::colour(const Brush& brush, double x, double y) const {
  const CornerWeights::Weights weights =
      brush.isSpeck ? nearestOnOutline(brush.corners, x, y) : brush.weights.at(x, y);
  Colour out(1, 1, 1, 1);
  if (brush.sampler) {
    const OldPlace& place = brush.place;
    out = brush.sampler->at(
        place.first[0] + weights[1] * place.second[0] + weights[2] * place.third[0],
        place.first[1] + weights[1] * place.second[1] + weights[2] * place.third[1],
        brush.footprint);
  }
  if (kind_ == MapKind::Normal) return vector(brush, weights, out);
  if (!input_.triangles.colours.empty())
    out = out * Colour(interpolated<4>(input_.triangles.colours, brush.triangle, weights));
  return out * Colour(brush.material->factor);
}

Colour Painter::vector(const Brush& brush, const CornerWeights::Weights& weights,
                       Colour texel) const {
  const BakeTriangles& from = input_.triangles;
  const TangentFrames frames = {interpolated<3>(from.normals, brush.triangle, weights),
                                interpolated<4>(from.oldTangents, brush.triangle, weights),
                                interpolated<4>(from.tangents, brush.triangle, weights)};
  const Colour half(0.5f, 0.5f, 0.5f, 0.5f);
  Colour bump(0, 0, 1, 1);
  if (brush.sampler) bump = Colour(texel.v + texel.v - 1) * Colour(brush.material->factor);
  Colour out = turnedNormal(bump, frames) * half + half;
  out.v[3] = texel.v[3];
  return out;
}

}  // namespace abflat
