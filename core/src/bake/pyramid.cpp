#include "bake/pyramid.h"

#include <algorithm>
#include <array>

#include "bake/colour.h"
#include "bake/texels.h"

namespace abflat {
namespace {

std::uint32_t halved(std::uint32_t n) { return std::max(1u, n / 2); }

/// What element `i` of `n` adds to the means of `halved(n)` equal parts of all.
struct PartShares {
  std::array<std::uint32_t, 2> part{};
  std::array<float, 2> share{};  ///< 0: none
};

PartShares partShares(std::uint32_t i, std::uint32_t n) {
  if (n == 1) return {{0, 0}, {1, 0}};
  const std::uint32_t parts = n / 2, k = i / 2;
  if (n % 2 == 0) return {{k, 0}, {0.5f, 0}};
  const auto of = [n](std::uint32_t x) { return static_cast<float>(x) / static_cast<float>(n); };
  if (i % 2 == 1) return {{k, 0}, {of(parts), 0}};
  return {{std::min(k, parts - 1), k > 0 ? k - 1 : 0}, {of(parts - k), k > 0 ? of(k) : 0}};
}

/// The same for the part with number `j`: up to three elements from 2 j on.
std::array<float, 3> elementShares(std::uint32_t j, std::uint32_t n) {
  if (n == 1) return {1, 0, 0};
  if (n % 2 == 0) return {0.5f, 0.5f, 0};
  const std::uint32_t parts = n / 2;
  const auto of = [n](std::uint32_t x) { return static_cast<float>(x) / static_cast<float>(n); };
  return {of(parts - j), of(parts), of(j + 1)};
}

/// Halves an image, row by row as it comes, and hands each row on.
template <class Texel>
class Halving {
 public:
  using Number = typename Texel::Number;

  Halving(std::uint32_t width, std::uint32_t height, Pyramid::Level& out, const Codec& codec)
      : inWidth_(width), inHeight_(height), out_(out), codec_(codec) {
    out_.width = halved(width);
    out_.height = halved(height);
    const std::size_t bytes =
        sizeof(Number) * Texel::kChannels * std::size_t{out_.width} * out_.height;
    out_.storage.resize((bytes + 1) / 2);
    out_.pixels = out_.storage.data();
    for (std::vector<Colour>& row : sums_) row.resize(out_.width);
    for (std::uint32_t x = 0; x < out_.width; ++x) shares_.push_back(elementShares(x, width));
  }

  void passTo(Halving* next) { next_ = next; }

  void add(const std::vector<Colour>& row) {
    const PartShares to = partShares(read_, inHeight_);
    for (std::size_t k = 0; k < 2; ++k)
      if (to.share[k] > 0) addTo(sums_[to.part[k] % 2], row, to.share[k]);
    ++read_;
    const bool isLast = read_ == inHeight_;
    const std::uint32_t complete = inHeight_ % 2 == 0 ? read_ / 2 : (read_ - 1) / 2;
    if (written_ < out_.height && (isLast || written_ < complete)) finish();
  }

 private:
  void addTo(std::vector<Colour>& sums, const std::vector<Colour>& row, float factor) const {
    for (std::uint32_t x = 0; x < out_.width; ++x) {
      const std::array<float, 3>& share = shares_[x];
      const Colour* const c = &row[std::size_t{2} * x];
      Colour sum = c[0] * share[0];
      if (inWidth_ > 1) sum = sum + c[1] * share[1];
      if (share[2] > 0) sum = sum + c[2] * share[2];
      sums[x] = sums[x] + sum * factor;
    }
  }

  void finish() {
    std::vector<Colour>& row = sums_[written_ % 2];
    Number* texel = reinterpret_cast<Number*>(out_.storage.data()) +
                    std::size_t{written_} * out_.width * Texel::kChannels;
    for (std::uint32_t x = 0; x < out_.width; ++x, texel += Texel::kChannels)
      store(Texel::kIsWeighed ? settled(row[x]) : row[x], codec_, Texel::kChannels, texel);
    if (next_) next_->add(row);
    std::fill(row.begin(), row.end(), Colour());
    ++written_;
  }

  std::uint32_t inWidth_, inHeight_, read_ = 0, written_ = 0;
  Pyramid::Level& out_;
  const Codec& codec_;
  std::vector<std::array<float, 3>> shares_;
  std::array<std::vector<Colour>, 2> sums_;  ///< of rows that are not complete, by parity
  Halving* next_ = nullptr;
};

template <class Texel>
void reduce(const ImageView& image, const Codec& codec, Pyramid& pyramid) {
  std::vector<Halving<Texel>> halvings;
  halvings.reserve(pyramid.levels.size());
  for (std::size_t l = 1; l < pyramid.levels.size(); ++l) {
    const Pyramid::Level& above = pyramid.levels[l - 1];
    halvings.emplace_back(above.width, above.height, pyramid.levels[l], codec);
  }
  for (std::size_t l = 1; l < halvings.size(); ++l) halvings[l - 1].passTo(&halvings[l]);
  const Decoding decoding(codec);
  const auto* texel = static_cast<const typename Texel::Number*>(image.pixels);
  std::vector<Colour> row(image.width);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (Colour& c : row) {
      c = Texel::load(texel, decoding);
      texel += Texel::kChannels;
    }
    halvings.front().add(row);
  }
}

}  // namespace

int mostReductions(const ImageView& image) {
  int out = 0;
  for (std::uint32_t side = std::max(image.width, image.height); side > 1; side /= 2) ++out;
  return out;
}

Pyramid makePyramid(const BakeTexture& texture, const Codec& codec, int reductions) {
  Pyramid out;
  const ImageView& image = texture.image;
  out.levels.resize(1 + static_cast<std::size_t>(reductions));
  out.levels[0].width = image.width;
  out.levels[0].height = image.height;
  out.levels[0].pixels = image.pixels;
  if (reductions > 0)
    withTexelType(texture, [&](auto texel) { reduce<decltype(texel)>(image, codec, out); });
  return out;
}

}  // namespace abflat
