#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

#include "abflat/bake.h"
#include "base/point2.h"
#include "catch.h"

namespace abflat::test {

/// Rows from the top, numbers of 8 or 16 bits.
struct Image {
  std::uint32_t width = 0, height = 0;
  int channels = 4, bits = 8;
  std::vector<std::uint8_t> bytes;

  Image() = default;
  Image(std::uint32_t w, std::uint32_t h, int count, int depth = 8)
      : width(w), height(h), channels(count), bits(depth) {
    bytes.resize(std::size_t{w} * h * static_cast<std::size_t>(count * depth / 8));
  }

  ImageView view() const { return {bytes.data(), width, height, channels, bits}; }
  int at(std::size_t x, std::size_t y, int channel) const {
    const std::size_t i = index(x, y, channel);
    if (bits == 8) return bytes[i];
    std::uint16_t value;
    std::memcpy(&value, &bytes[2 * i], 2);
    return value;
  }
  void set(std::size_t x, std::size_t y, int channel, int value) {
    const std::size_t i = index(x, y, channel);
    const auto number = static_cast<std::uint16_t>(value);
    if (bits == 8)
      bytes[i] = static_cast<std::uint8_t>(value);
    else
      std::memcpy(&bytes[2 * i], &number, 2);
  }
  std::vector<int> pixel(std::size_t x, std::size_t y) const {
    std::vector<int> out;
    for (int d = 0; d < channels; ++d) out.push_back(at(x, y, d));
    return out;
  }

 private:
  std::size_t index(std::size_t x, std::size_t y, int channel) const {
    return (y * width + x) * static_cast<std::size_t>(channels) + static_cast<std::size_t>(channel);
  }
};

/// What sRGB defines, both ways.
inline double linearised(double x) {
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}
inline double encoded(double x) {
  return x <= 0.0031308 ? x * 12.92 : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

/// The centre of a pixel, in pixels.
inline Point2 centreOf(std::size_t x, std::size_t y) {
  return {static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5};
}

inline Image noise(std::uint32_t width, std::uint32_t height, int channels, int bits,
                   unsigned seed) {
  Image out(width, height, channels, bits);
  std::mt19937 random(seed);
  for (std::uint8_t& b : out.bytes) b = static_cast<std::uint8_t>(random());
  return out;
}

inline Image baked(const BakeInput& input, const BakeOptions& options) {
  Image out(options.width, options.height, options.channels, options.bits);
  out.bytes.clear();
  std::uint32_t next = 0;
  const Status status =
      bake(input, options,
           [&](std::uint32_t first, std::uint32_t rows, const std::vector<std::uint8_t>& bytes) {
             CHECK(first == next);
             next += rows;
             out.bytes.insert(out.bytes.end(), bytes.begin(), bytes.end());
             return true;
           });
  REQUIRE(status.message.empty());
  REQUIRE(next == options.height);
  return out;
}

/// A triangle whose old uv are `toOld` of its new ones.
template <class ToOld>
void addTriangle(BakeTriangles& triangles, const std::array<Point2, 3>& uv, const ToOld& toOld) {
  for (const Point2& p : uv) {
    const Point2 old = toOld(p);
    triangles.uv.insert(triangles.uv.end(), p.begin(), p.end());
    triangles.oldUv.insert(triangles.oldUv.end(), old.begin(), old.end());
  }
  triangles.materials.push_back(0);
}

/// Two triangles that form a parallelogram from `a` with the sides `u` and `v`.
template <class ToOld>
void addQuad(BakeTriangles& triangles, const Point2& a, const Point2& u, const Point2& v,
             const ToOld& toOld) {
  const Point2 b = {a[0] + u[0], a[1] + u[1]}, d = {a[0] + v[0], a[1] + v[1]};
  const Point2 c = {b[0] + v[0], b[1] + v[1]};
  addTriangle(triangles, {a, b, c}, toOld);
  addTriangle(triangles, {a, c, d}, toOld);
}

inline Point2 unchanged(const Point2& p) { return p; }

/// One texture on a square that fills the new image.
template <class ToOld>
BakeInput squareWith(const Image& texture, const ToOld& toOld) {
  BakeInput out;
  out.textures.resize(1);
  out.textures[0].image = texture.view();
  out.materials.resize(1);
  out.materials[0].texture = 0;
  addQuad(out.triangles, {0, 0}, {1, 0}, {0, 1}, toOld);
  return out;
}

inline BakeOptions asLargeAs(const Image& image) {
  BakeOptions out;
  out.width = image.width;
  out.height = image.height;
  out.channels = image.channels;
  out.bits = image.bits;
  out.threads = 1;
  return out;
}

}  // namespace abflat::test
