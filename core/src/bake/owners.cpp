#include "bake/owners.h"

#include <algorithm>

namespace abflat {
namespace {

/// Coordinates beyond are of no use; so many texels can still be counted.
constexpr double kFarthest = 1e6;

}  // namespace

BandedTriangles::BandedTriangles(const std::vector<double>& uv, std::uint32_t width,
                                 std::uint32_t height, std::uint32_t bandRows)
    : uv_(uv), width_(width), height_(height), bandRows_(bandRows), isSpeck_(uv.size() / 6) {
  const auto count = static_cast<std::uint32_t>(uv.size() / 6);
  const std::size_t bands = (height + bandRows - 1) / bandRows;
  firstOfBand_.assign(bands + 1, 0);
  for (std::uint32_t t = 0; t < count; ++t) {
    const TexelRange in = bandsOf(triangle(t));
    for (std::int64_t b = in.first; b < in.last; ++b)
      ++firstOfBand_[static_cast<std::size_t>(b) + 1];
    if (!in.isEmpty()) isSpeck_[t] = !hasCentre(triangle(t), width, height);
  }
  for (std::size_t b = 0; b < bands; ++b) firstOfBand_[b + 1] += firstOfBand_[b];
  inBand_.resize(firstOfBand_[bands] + 1);
  std::vector<std::size_t> next(firstOfBand_.begin(), firstOfBand_.end() - 1);
  for (std::uint32_t t = 0; t < count; ++t) {
    const TexelRange in = bandsOf(triangle(t));
    for (std::int64_t b = in.first; b < in.last; ++b)
      inBand_[next[static_cast<std::size_t>(b)]++] = t;
  }
}

TexelRange BandedTriangles::rows(std::size_t band) const {
  const std::int64_t first = static_cast<std::int64_t>(band) * bandRows_;
  return {first, std::min<std::int64_t>(height_, first + bandRows_)};
}

TexelRange BandedTriangles::rowsAround(std::size_t band) const {
  const TexelRange in = rows(band);
  return {std::max<std::int64_t>(0, in.first - 1), std::min<std::int64_t>(height_, in.last + 1)};
}

TexelTriangle BandedTriangles::triangle(std::uint32_t t) const {
  TexelTriangle out;
  for (std::size_t k = 0; k < 3; ++k) {
    const double* const uv = &uv_[6 * std::size_t{t} + 2 * k];
    out[k] = {std::clamp(uv[0], -kFarthest, kFarthest) * width_,
              std::clamp(uv[1], -kFarthest, kFarthest) * height_};
  }
  return out;
}

TexelRange BandedTriangles::bandsOf(const TexelTriangle& triangle) const {
  if (hasNoArea(triangle)) return {};
  const TexelRange rows = rowsOf(triangle, height_);
  if (rows.isEmpty()) return {};
  const std::int64_t first = std::max<std::int64_t>(0, rows.first - 1);
  const std::int64_t last = std::min<std::int64_t>(height_, rows.last + 1);
  return {first / bandRows_, (last - 1) / bandRows_ + 1};
}

std::vector<std::uint32_t> ownersAround(const BandedTriangles& triangles, std::size_t band) {
  const TexelRange rows = triangles.rowsAround(band);
  const std::size_t width = triangles.width();
  std::vector<std::uint32_t> out(width * static_cast<std::size_t>(rows.last - rows.first),
                                 kNoOwner);
  for (const bool isSpeck : {false, true}) {
    for (std::uint32_t i = 0; i < triangles.countIn(band); ++i) {
      const std::uint32_t t = triangles.begin(band)[i];
      if (triangles.isSpeck(t) != isSpeck) continue;
      const TexelTriangle corners = triangles.triangle(t);
      const TexelRange touched = rowsOf(corners, triangles.height());
      const std::int64_t last = std::min(touched.last, rows.last);
      for (std::int64_t y = std::max(touched.first, rows.first); y < last; ++y) {
        const double top = static_cast<double>(y) + (isSpeck ? 0 : 0.5);
        const std::optional<Span> span = spanBetween(corners, top, isSpeck ? top + 1 : top);
        if (!span) continue;
        const TexelRange in = isSpeck ? touchedBy(span->left, span->right, triangles.width())
                                      : centresWithin(span->left, span->right, triangles.width());
        std::uint32_t* const row = &out[static_cast<std::size_t>(y - rows.first) * width];
        for (std::int64_t x = in.first; x < in.last; ++x)
          if (row[x] == kNoOwner) row[x] = i;
      }
    }
  }
  return out;
}

}  // namespace abflat
