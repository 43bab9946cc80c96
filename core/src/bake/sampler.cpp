#include "bake/sampler.h"

#include <cmath>

namespace abflat {
namespace {

std::int64_t floorOf(double x) {
  const auto towardsZero = static_cast<std::int64_t>(x);
  return towardsZero - (x < static_cast<double>(towardsZero) ? 1 : 0);
}

/// Texels until a texture of `count` repeats.
std::int64_t periodOf(std::int64_t count, Wrap wrap) {
  return wrap == Wrap::Mirror ? 2 * count : count;
}

std::int64_t wrapped(std::int64_t i, std::int64_t count, Wrap wrap) {
  if (i >= 0 && i < count) return i;
  if (wrap == Wrap::Clamp) return i < 0 ? 0 : count - 1;
  const std::int64_t period = periodOf(count, wrap);
  i = i < 0 ? i + period : i >= period ? i - period : i;
  if (i < 0 || i >= period) {  // divisions take long
    i %= period;
    if (i < 0) i += period;
  }
  return i < count ? i : period - 1 - i;
}

}  // namespace

Sampler::Sampler(const BakeTexture& texture, const Codec& codec, int reductions)
    : pyramid_(makePyramid(texture, codec, reductions)),
      decoding_(codec),
      wrapU_(texture.wrapU),
      wrapV_(texture.wrapV) {
  const Pyramid::Level& first = pyramid_.levels[0];
  for (const Pyramid::Level& level : pyramid_.levels)
    grids_.push_back({level.pixels, level.width, level.height, 1.0 * level.width / first.width,
                      1.0 * level.height / first.height});
  read_ = withTexelType(texture, [](auto texel) { return &Sampler::read<decltype(texel)>; });
}

Point2 Sampler::inFirstPeriod(const Point2& place) const {
  const auto moved = [](double x, std::int64_t count, Wrap wrap) {
    if (wrap == Wrap::Clamp) return x;
    const auto period = static_cast<double>(periodOf(count, wrap));
    return x - std::floor(x / period) * period;
  };
  return {moved(place[0], grids_[0].width, wrapU_), moved(place[1], grids_[0].height, wrapV_)};
}

template <class Texel>
Colour Sampler::bilinear(std::size_t level, double x, double y) const {
  const Grid& grid = grids_[level];
  const double left = x * grid.scaleX - 0.5, top = y * grid.scaleY - 0.5;
  std::int64_t i = floorOf(left), j = floorOf(top), right = i + 1, below = j + 1;
  const auto toRight = static_cast<float>(left - static_cast<double>(i));
  const auto toBelow = static_cast<float>(top - static_cast<double>(j));
  if (i < 0 || j < 0 || right >= grid.width || below >= grid.height) {
    i = wrapped(i, grid.width, wrapU_);
    right = wrapped(right, grid.width, wrapU_);
    j = wrapped(j, grid.height, wrapV_);
    below = wrapped(below, grid.height, wrapV_);
  }
  const auto* const pixels = static_cast<const typename Texel::Number*>(grid.pixels);
  const auto at = [&](std::int64_t column, std::int64_t row) {
    return Texel::load(pixels + (row * grid.width + column) * Texel::kChannels, decoding_);
  };
  const Colour upper = at(i, j) * (1 - toRight) + at(right, j) * toRight;
  const Colour lower = at(i, below) * (1 - toRight) + at(right, below) * toRight;
  return upper * (1 - toBelow) + lower * toBelow;
}

template <class Texel>
Colour Sampler::read(const Sampler& sampler, double x, double y, const TexelFootprint& footprint) {
  const auto level = static_cast<std::size_t>(footprint.level);
  Colour sum, next;
  for (int k = 0; k < footprint.probes; ++k) {
    const double px = x + footprint.firstX + k * footprint.stepX;
    const double py = y + footprint.firstY + k * footprint.stepY;
    sum = sum + sampler.bilinear<Texel>(level, px, py);
    if (footprint.next > 0) next = next + sampler.bilinear<Texel>(level + 1, px, py);
  }
  sum = (sum * (1 - footprint.next) + next * footprint.next) *
        (1 / static_cast<float>(footprint.probes));
  return Texel::kIsWeighed ? settled(sum) : sum;
}

}  // namespace abflat
