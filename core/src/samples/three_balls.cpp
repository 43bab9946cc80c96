#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "samples/generators.h"
#include "samples/grid.h"

namespace abflat {
namespace {

constexpr double kFoot = 0.42;    // radius where the neck leaves the plane; a block is 1 wide
constexpr double kFillet = 0.17;  // radius of the arc from the plane into the neck
constexpr double kBall = 0.4;
constexpr double kNeck = kFoot - kFillet;

/// Point of the outline of a ball on its neck: distance from the axis and height, `s` in [0,1] by
/// arc length from the plane to the top.
std::array<double, 2> outline(double s) {
  // The quarter fillet ends vertically at radius kNeck, where the sphere is cut.
  // Polar angle of the cut, from the lower pole.
  const double below = portable::atan2(kNeck, std::sqrt(kBall * kBall - kNeck * kNeck));
  const double filletLength = kFillet * kSamplePi / 2, ballLength = kBall * (kSamplePi - below);
  double length = s * (filletLength + ballLength);
  if (length < filletLength) {
    const double a = length / kFillet;
    return {kFoot - kFillet * portable::sin(a), kFillet * (1 - portable::cos(a))};
  }
  const double a = below + (length - filletLength) / kBall;
  return {kBall * portable::sin(a), kFillet + kBall * (portable::cos(below) - portable::cos(a))};
}

/// Square lattice of blocks; vertices inside block squares with a ball are left out.
class Patch {
 public:
  explicit Patch(unsigned cells) : cells_(cells), lattice_(3 * cells + 1) {}

  PolygonMesh make() {
    for (unsigned y = 0; y < lattice_; ++y)
      for (unsigned x = 0; x < lattice_; ++x)
        vertex_.push_back(isInBall(x, y) ? kNone : mesh_.addPoint({at(x), at(y), 0}));
    for (unsigned by = 0; by < 3; ++by)
      for (unsigned bx = 0; bx < 3; ++bx) isBall(bx, by) ? addBall(bx, by) : addFlat(bx, by);
    return mesh_.finish();
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  static bool isBall(unsigned bx, unsigned by) {
    return (by == 0 && bx != 1) || (by == 2 && bx == 1);
  }
  double at(unsigned i) const { return static_cast<double>(i) / cells_; }
  bool isInBall(unsigned x, unsigned y) const {
    return x % cells_ != 0 && y % cells_ != 0 && isBall(x / cells_, y / cells_);
  }
  std::uint32_t vertexAt(unsigned x, unsigned y) const { return vertex_[y * lattice_ + x]; }

  void addFlat(unsigned bx, unsigned by) {
    for (unsigned y = by * cells_; y < (by + 1) * cells_; ++y)
      for (unsigned x = bx * cells_; x < (bx + 1) * cells_; ++x) {
        const std::uint32_t a = vertexAt(x, y), b = vertexAt(x + 1, y), c = vertexAt(x + 1, y + 1),
                            d = vertexAt(x, y + 1);
        mesh_.addTriangle(a, b, (x + y) % 2 == 0 ? c : d);
        mesh_.addTriangle((x + y) % 2 == 0 ? a : b, c, d);
      }
  }

  /// Closed outline of a block, counter-clockwise from the middle of its right side.
  std::vector<std::uint32_t> blockRing(unsigned bx, unsigned by) const {
    std::vector<std::uint32_t> out;
    const unsigned x0 = bx * cells_, y0 = by * cells_, n = cells_;
    for (unsigned i = 0; i < n; ++i) out.push_back(vertexAt(x0 + n, y0 + i));
    for (unsigned i = 0; i < n; ++i) out.push_back(vertexAt(x0 + n - i, y0 + n));
    for (unsigned i = 0; i < n; ++i) out.push_back(vertexAt(x0, y0 + n - i));
    for (unsigned i = 0; i < n; ++i) out.push_back(vertexAt(x0 + i, y0));
    std::rotate(out.begin(), out.begin() + n / 2, out.end());
    out.push_back(out.front());
    return out;
  }

  /// Closed: the last vertex is the first.
  std::vector<std::uint32_t> circle(unsigned count, const Point& centre, double radius) {
    std::vector<std::uint32_t> out;
    for (unsigned i = 0; i < count; ++i) {
      const double phi = 2 * kSamplePi * i / count;
      out.push_back(mesh_.addPoint({centre[0] + radius * portable::cos(phi),
                                    centre[1] + radius * portable::sin(phi), centre[2]}));
    }
    out.push_back(out.front());
    return out;
  }

  /// Halfway between a block's outline and the foot of its ball, so that no triangle is long.
  std::vector<std::uint32_t> betweenSquareAndFoot(const std::vector<std::uint32_t>& square,
                                                  double cx, double cy) {
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i + 1 < square.size(); ++i) {
      const Point p = mesh_.point(square[i]);
      const double x = p[0] - cx, y = p[1] - cy;
      const double scale = (1 + kFoot / portable::hypot(x, y)) / 2;
      out.push_back(mesh_.addPoint({cx + scale * x, cy + scale * y, 0}));
    }
    out.push_back(out.front());
    return out;
  }

  void addBall(unsigned bx, unsigned by) {
    const double edge = 1.0 / cells_, cx = bx + 0.5, cy = by + 0.5;
    const unsigned steps = static_cast<unsigned>(std::lround(1.45 / edge));
    std::vector<std::uint32_t> ring = blockRing(bx, by);
    const auto inwards = [&](const std::vector<std::uint32_t>& next) {
      joinRows(mesh_, ring, next);
      ring = next;
    };
    inwards(betweenSquareAndFoot(ring, cx, cy));
    for (unsigned k = 0; k < steps; ++k) {
      const auto [radius, z] = outline(static_cast<double>(k) / steps);
      const long count = std::max(6L, std::lround(2 * kSamplePi * radius / edge));
      inwards(circle(static_cast<unsigned>(count), {cx, cy, z}, radius));
    }
    inwards({mesh_.addPoint({cx, cy, outline(1)[1]})});
  }

  unsigned cells_;    ///< along the side of a block
  unsigned lattice_;  ///< vertices along the side of the patch
  MeshBuilder mesh_;
  std::vector<std::uint32_t> vertex_;
};

}  // namespace

// A square outline of a block joins a circle: even counts keep its corners symmetric.
PolygonMesh makeThreeBalls(double detail) { return Patch(2 * scaledCount(5, detail)).make(); }

}  // namespace abflat
