#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace abflat {

/// Points in the caller's memory: x, y and z of each, finite, in any unit. `stride` is the number
/// of bytes from one point to the next. Nothing needs to be aligned.
class PointView {
 public:
  PointView(const float* first, std::size_t count, std::size_t stride = 3 * sizeof(float))
      : first_(reinterpret_cast<const char*>(first)),
        count_(count),
        stride_(stride),
        isFloat_(true) {}
  PointView(const double* first, std::size_t count, std::size_t stride = 3 * sizeof(double))
      : first_(reinterpret_cast<const char*>(first)), count_(count), stride_(stride) {}

  std::size_t size() const { return count_; }
  std::array<double, 3> operator[](std::size_t i) const {
    const char* const at = first_ + i * stride_;
    return isFloat_ ? read<float>(at) : read<double>(at);
  }

 private:
  template <class T>
  static std::array<double, 3> read(const char* at) {
    std::array<T, 3> p;
    std::memcpy(p.data(), at, sizeof p);
    return {p[0], p[1], p[2]};
  }

  const char* first_;
  std::size_t count_, stride_;
  bool isFloat_ = false;
};

/// Triangles in the caller's memory: 3 vertices each, one after another, counted from 0. They are
/// 16-bit and unsigned, or integers of 32 or 64 bits, of which none is negative. `stride` is the
/// number of bytes from one triangle to the next. Nothing needs to be aligned.
class TriangleView {
 public:
  template <class Index>
  TriangleView(const Index* first, std::size_t count, std::size_t stride = 3 * sizeof(Index))
      : first_(reinterpret_cast<const char*>(first)),
        count_(count),
        stride_(stride),
        indexSize_(sizeof(Index)) {
    static_assert(std::is_integral_v<Index> && sizeof(Index) >= 2 &&
                      (sizeof(Index) > 2 || std::is_unsigned_v<Index>),
                  "16-bit unsigned, 32-bit or 64-bit integers");
  }

  std::size_t size() const { return count_; }
  /// The vertex at corner 0, 1 or 2 of a triangle. A negative one comes out larger than any.
  std::uint64_t vertex(std::size_t triangle, std::size_t corner) const {
    const char* const at = first_ + triangle * stride_ + corner * indexSize_;
    return indexSize_ == 2   ? read<std::uint16_t>(at)
           : indexSize_ == 4 ? read<std::uint32_t>(at)
                             : read<std::uint64_t>(at);
  }

 private:
  template <class T>
  static std::uint64_t read(const char* at) {
    T v;
    std::memcpy(&v, at, sizeof v);
    return v;
  }

  const char* first_;
  std::size_t count_, stride_, indexSize_;
};

/// A mesh of triangles in the caller's memory, counter-clockwise seen from outside. It is only
/// read, and only until the function that is given it returns. Polygons, texcoords, normals and
/// materials need a PolygonMesh.
struct MeshView {
  PointView positions;
  TriangleView triangles;
};

}  // namespace abflat
