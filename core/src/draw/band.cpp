#include "draw/band.h"

#include <algorithm>
#include <cmath>

namespace abflat {
namespace {

int clamped(double value, int low, int high) {
  return static_cast<int>(std::clamp(value, static_cast<double>(low), static_cast<double>(high)));
}

double distanceTo(const PixelPoint& p, const PixelPoint& a, const PixelPoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
  const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  const double x = p.x - a.x - t * dx, y = p.y - a.y - t * dy;
  return std::sqrt(x * x + y * y);
}

/// Paints over a colour that is multiplied with its alpha.
void paint(std::array<float, 4>& pixel, const Rgb& colour, float alpha) {
  for (std::size_t d = 0; d < 3; ++d) pixel[d] = pixel[d] * (1 - alpha) + colour[d] * alpha;
  pixel[3] = pixel[3] * (1 - alpha) + alpha;
}

std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255));
}

}  // namespace

Band::Band(int width, int firstRow, int rows) : width_(width), firstRow_(firstRow), rows_(rows) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(rows);
  areas_.resize(pixels);
  for (std::vector<float>& line : lines_) line.resize(pixels);
}

/// Everything to the right of an edge that goes down gains as much cover as the edge is high.
void Band::addEdge(PixelPoint from, PixelPoint to) {
  if (from.y == to.y) return;
  const double sign = from.y < to.y ? 1 : -1;
  if (sign < 0) std::swap(from, to);
  const double slope = (to.x - from.x) / (to.y - from.y);
  const int last = clamped(std::ceil(to.y), top_, bottom_);
  for (int y = clamped(std::floor(from.y), top_, bottom_); y < last; ++y) {
    const double top = std::max(from.y, static_cast<double>(y)), bottom = std::min(to.y, y + 1.0);
    const double most = static_cast<double>(stride_) - 2;
    const double atTop = std::clamp(from.x + (top - from.y) * slope - left_, 0.0, most);
    const double atBottom = std::clamp(from.x + (bottom - from.y) * slope - left_, 0.0, most);
    const double low = std::min(atTop, atBottom), high = std::max(atTop, atBottom);
    double* row = &steps_[static_cast<std::size_t>(y - top_) * stride_];
    for (auto column = static_cast<std::size_t>(low);; ++column) {
      const auto at = static_cast<double>(column);
      const double begin = std::max(low, at), end = std::min(high, at + 1);
      const double share = high > low ? (end - begin) / (high - low) : 1;
      const double step = sign * (bottom - top) * share, beside = (begin + end) / 2 - at;
      row[column] += step * (1 - beside);
      row[column + 1] += step * beside;
      if (at + 1 >= high) break;
    }
  }
}

void Band::fill(const std::vector<PixelPoint>& polygon, const Rgb& colour) {
  PixelPoint low = polygon.front(), high = low;
  for (const PixelPoint& p : polygon) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  top_ = clamped(std::floor(low.y), firstRow_, firstRow_ + rows_);
  bottom_ = clamped(std::ceil(high.y), firstRow_, firstRow_ + rows_);
  left_ = clamped(std::floor(low.x), 0, width_);
  const int right = clamped(std::ceil(high.x), 0, width_);
  if (top_ >= bottom_ || left_ >= right) return;
  stride_ = static_cast<std::size_t>(right - left_) + 2;
  steps_.assign(stride_ * static_cast<std::size_t>(bottom_ - top_), 0);
  for (std::size_t i = 0; i < polygon.size(); ++i)
    addEdge(polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0]);
  for (int y = top_; y < bottom_; ++y) {
    const double* step = &steps_[static_cast<std::size_t>(y - top_) * stride_];
    std::array<float, 4>* pixel =
        &areas_[static_cast<std::size_t>(y - firstRow_) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(left_)];
    double sum = 0;
    for (int x = left_; x < right; ++x, ++pixel) {
      sum += *step++;
      const auto share = static_cast<float>(std::min(1.0, std::abs(sum)));
      for (std::size_t d = 0; d < 3; ++d) (*pixel)[d] += share * colour[d];
      (*pixel)[3] += share;
    }
  }
}

void Band::draw(Line kind, const PixelPoint& from, const PixelPoint& to, double width) {
  std::vector<float>& shares = lines_[static_cast<std::size_t>(kind)];
  const double reach = width / 2 + 0.5;  // from the middle of a pixel
  const int top = clamped(std::floor(std::min(from.y, to.y) - reach), firstRow_, firstRow_ + rows_);
  const int bottom =
      clamped(std::ceil(std::max(from.y, to.y) + reach), firstRow_, firstRow_ + rows_);
  const int left = clamped(std::floor(std::min(from.x, to.x) - reach), 0, width_);
  const int right = clamped(std::ceil(std::max(from.x, to.x) + reach), 0, width_);
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      const double distance = distanceTo({x + 0.5, y + 0.5}, from, to);
      const auto share =
          static_cast<float>(std::clamp(reach - distance, 0.0, std::min(1.0, width)));
      float& now =
          shares[static_cast<std::size_t>(y - firstRow_) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(x)];
      now = std::max(now, share);
    }
}

std::vector<std::uint8_t> Band::rgba(const BandInks& inks) const {
  std::vector<std::uint8_t> out;
  out.reserve(4 * areas_.size());
  for (std::size_t i = 0; i < areas_.size(); ++i) {
    std::array<float, 4> pixel = areas_[i];
    // Layouts that overlap cover a pixel more than once.
    if (pixel[3] > 1)
      for (float& value : pixel) value /= areas_[i][3];
    paint(pixel, inks.ink, lines_[0][i] * inks.thinOpacity);
    paint(pixel, inks.ink, lines_[1][i] * inks.thickOpacity);
    paint(pixel, inks.mark, lines_[2][i]);
    for (std::size_t d = 0; d < 3; ++d)
      out.push_back(pixel[3] > 0 ? toByte(pixel[d] / pixel[3]) : 0);
    out.push_back(toByte(pixel[3]));
  }
  return out;
}

}  // namespace abflat
