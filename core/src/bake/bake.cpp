#include "abflat/bake.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "bake/border.h"
#include "bake/check_input.h"
#include "bake/codec.h"
#include "bake/nearest.h"
#include "bake/owners.h"
#include "bake/painter.h"
#include "bake/texels.h"
#include "base/guarded.h"
#include "base/parallel.h"

namespace abflat {
namespace {

/// No texel that a chart touches is farther from one whose centre it covers, unless it is narrower
/// than a texel.
constexpr double kTouched = 1.5;

/// Per column, rows of covered texels outside a band.
struct CoveredBeyond {
  std::vector<std::int32_t> above, below;  ///< the nearest ones
};

class Baking {
 public:
  Baking(const BakeInput& input, const BakeOptions& options)
      : options_(options),
        pool_(static_cast<unsigned>(options.threads)),
        width_(options.width),
        pixelBytes_(static_cast<std::size_t>(options.channels * options.bits / 8)),
        codec_(options.kind == MapKind::Normal ? ColourSpace::Linear : options.space, options.bits),
        layout_(input.triangles.uv, options.width, options.height, options.bandRows),
        painter_(input, options.kind, layout_, pool_),
        borders_(layout_.bandCount()),
        beyond_(layout_.bandCount()),
        background_(pixelBytes_) {
    write(Colour(options.background), Codec(ColourSpace::Linear, options.bits), background_.data());
  }

  Status run(const RowSink& sink) {
    const std::size_t bands = layout_.bandCount();
    parallelFor(&pool_, bands, [&](std::size_t b) { findBorder(b); });
    passOnCovered();
    std::vector<std::vector<std::uint8_t>> images(std::min<std::size_t>(bands, pool_.threads()));
    for (std::size_t first = 0; first < bands; first += images.size()) {
      const std::size_t count = std::min(images.size(), bands - first);
      parallelFor(&pool_, count, [&](std::size_t i) { images[i] = paint(first + i); });
      for (std::size_t i = 0; i < count; ++i) {
        const TexelRange rows = layout_.rows(first + i);
        if (!sink(static_cast<std::uint32_t>(rows.first),
                  static_cast<std::uint32_t>(rows.last - rows.first), images[i]))
          return {StatusCode::Aborted, "the caller cancelled the run"};
      }
    }
    return {};
  }

 private:
  void write(const Colour& colour, const Codec& codec, std::uint8_t* pixel) const {
    if (options_.bits == 8) return store(colour, codec, options_.channels, pixel);
    std::array<std::uint16_t, 4> numbers;
    store(colour, codec, options_.channels, numbers.data());
    std::memcpy(pixel, numbers.data(), pixelBytes_);
  }

  /// Of the triangle with this number in a band.
  Brush brush(std::size_t band, std::size_t i) const {
    const std::uint32_t t = layout_.begin(band)[i];
    return painter_.brush(t, layout_.triangle(t), layout_.isSpeck(t));
  }

  void paintTexel(const Brush& brush, std::int64_t row, std::size_t x, std::uint8_t* pixel) const {
    write(painter_.colour(brush, static_cast<double>(x) + 0.5, static_cast<double>(row) + 0.5),
          codec_, pixel);
  }

  /// Paints the texels of a band that are next to one that is not covered, and notes which rows
  /// are covered.
  void findBorder(std::size_t band) {
    const TexelRange rows = layout_.rows(band), around = layout_.rowsAround(band);
    const std::vector<std::uint32_t> owners = ownersAround(layout_, band);
    const auto isBare = [&](std::int64_t row, std::size_t x) {
      return owners[static_cast<std::size_t>(row - around.first) * width_ + x] == kNoOwner;
    };
    CoveredBeyond& covered = beyond_[band];
    covered.above.assign(width_, kNowhere);
    covered.below.assign(width_, kNowhere);
    BorderPixels border(width_, static_cast<std::size_t>(rows.last - rows.first), pixelBytes_);
    for (std::int64_t row = rows.first; row < rows.last; ++row)
      for (std::size_t x = 0; x < width_; ++x) {
        if (isBare(row, x)) continue;
        covered.above[x] = static_cast<std::int32_t>(row);
        if (covered.below[x] == kNowhere) covered.below[x] = static_cast<std::int32_t>(row);
        if ((x > 0 && isBare(row, x - 1)) || (x + 1 < width_ && isBare(row, x + 1)) ||
            (row > around.first && isBare(row - 1, x)) ||
            (row + 1 < around.last && isBare(row + 1, x)))
          border.mark(static_cast<std::size_t>(row - rows.first), x);
      }
    border.settle();
    for (std::int64_t row = rows.first; row < rows.last; ++row)
      for (std::size_t x = 0; x < width_; ++x) {
        const auto r = static_cast<std::size_t>(row - rows.first);
        if (!border.isMarked(r, x)) continue;
        const std::size_t i = static_cast<std::size_t>(row - around.first) * width_ + x;
        paintTexel(brush(band, owners[i]), row, x, border.pixel(r, x));
      }
    borders_[band] = std::move(border);
  }

  /// From the last and the first covered row of each band to those beyond it.
  void passOnCovered() {
    std::vector<std::int32_t> last(width_, kNowhere), first(width_, kNowhere);
    const auto passOn = [&](std::vector<std::int32_t>& ofBand, std::vector<std::int32_t>& seen) {
      for (std::size_t x = 0; x < width_; ++x) {
        const std::int32_t own = ofBand[x];
        ofBand[x] = seen[x];
        if (own != kNowhere) seen[x] = own;
      }
    };
    for (CoveredBeyond& band : beyond_) passOn(band.above, last);
    for (std::size_t b = beyond_.size(); b-- > 0;) passOn(beyond_[b].below, first);
  }

  /// Per texel of a band, the row of the nearest covered texel in its column.
  std::vector<std::int32_t> nearestInColumns(std::size_t band, const std::uint32_t* owners) const {
    const TexelRange rows = layout_.rows(band);
    const auto count = static_cast<std::size_t>(rows.last - rows.first);
    std::vector<std::int32_t> out(count * width_);
    std::vector<std::int32_t> above = beyond_[band].above, below = beyond_[band].below;
    for (std::size_t r = 0; r < count; ++r)
      for (std::size_t x = 0; x < width_; ++x) {
        if (owners[r * width_ + x] != kNoOwner)
          above[x] = static_cast<std::int32_t>(rows.first) + static_cast<std::int32_t>(r);
        out[r * width_ + x] = above[x];
      }
    for (std::size_t r = count; r-- > 0;)
      for (std::size_t x = 0; x < width_; ++x) {
        const auto row = static_cast<std::int32_t>(rows.first) + static_cast<std::int32_t>(r);
        std::int32_t& nearest = out[r * width_ + x];
        if (nearest == row) below[x] = row;
        if (below[x] != kNowhere && (nearest == kNowhere || below[x] - row < row - nearest))
          nearest = below[x];
      }
    return out;
  }

  std::vector<std::uint8_t> paint(std::size_t band) const {
    const TexelRange rows = layout_.rows(band), around = layout_.rowsAround(band);
    const std::vector<std::uint32_t> all = ownersAround(layout_, band);
    const std::uint32_t* const owners =
        &all[static_cast<std::size_t>(rows.first - around.first) * width_];
    std::vector<Brush> from;
    from.reserve(layout_.countIn(band));
    for (std::size_t i = 0; i < layout_.countIn(band); ++i) from.push_back(brush(band, i));
    const std::vector<std::int32_t> nearest = nearestInColumns(band, owners);
    const auto count = static_cast<std::size_t>(rows.last - rows.first);
    std::vector<std::uint8_t> out(count * width_ * pixelBytes_);
    NearestInRow inRow;
    for (std::size_t r = 0; r < count; ++r) {
      const std::int64_t row = rows.first + static_cast<std::int64_t>(r);
      std::uint8_t* const pixels = &out[r * width_ * pixelBytes_];
      bool isFull = true;
      for (std::size_t x = 0; x < width_; ++x) {
        const std::uint32_t owner = owners[r * width_ + x];
        if (owner == kNoOwner)
          isFull = false;
        else
          paintTexel(from[owner], row, x, pixels + x * pixelBytes_);
      }
      if (isFull) continue;
      inRow.find(static_cast<std::int32_t>(row), &nearest[r * width_], width_);
      for (std::size_t x = 0; x < width_; ++x)
        if (owners[r * width_ + x] == kNoOwner)
          std::memcpy(pixels + x * pixelBytes_,
                      bare(row, x, inRow.columns()[x], &nearest[r * width_]), pixelBytes_);
    }
    return out;
  }

  /// The pixel of a texel that is not covered; `column` is that of the nearest one that is.
  const std::uint8_t* bare(std::int64_t row, std::size_t x, std::int32_t column,
                           const std::int32_t* nearestInColumn) const {
    if (column == kNowhere) return background_.data();
    const std::int64_t from = nearestInColumn[column];
    const double down = static_cast<double>(from - row);
    const double right = static_cast<double>(column) - static_cast<double>(x);
    const double reach = options_.padding + kTouched;
    if (!options_.fillsAll && right * right + down * down > reach * reach)
      return background_.data();
    const std::int64_t band = from / options_.bandRows;
    return borders_[static_cast<std::size_t>(band)].pixel(
        static_cast<std::size_t>(from - band * options_.bandRows),
        static_cast<std::size_t>(column));
  }

  const BakeOptions& options_;
  ThreadPool pool_;
  const std::size_t width_, pixelBytes_;
  const Codec codec_;
  const BandedTriangles layout_;
  const Painter painter_;
  std::vector<BorderPixels> borders_;     ///< by band
  std::vector<CoveredBeyond> beyond_;     ///< by band
  std::vector<std::uint8_t> background_;  ///< a pixel
};

}  // namespace

Status bake(const BakeInput& input, const BakeOptions& options, const RowSink& sink) {
  return guarded([&]() -> Status {
    if (Status s = checkOptions(options); !s.ok()) return s;
    if (Status s = checkInput(input, options.kind); !s.ok()) return s;
    return Baking(input, options).run(sink);
  });
}

}  // namespace abflat
