#include "gltf/origin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "abflat/gltf.h"
#include "base/number_text.h"

namespace abflat {
namespace gltf {
namespace {

using Point = std::array<double, 3>;

class Rounding {
 public:
  Rounding(const PolygonMesh& mesh, const std::vector<std::uint32_t>& triangleCorners)
      : mesh_(mesh), corners_(triangleCorners) {}

  Point offset() const {
    Point least, most;
    least.fill(std::numeric_limits<double>::infinity());
    most.fill(-least[0]);
    for (const std::uint32_t c : corners_)
      for (std::size_t d = 0; d < 3; ++d) {
        least[d] = std::min(least[d], at(c)[d]);
        most[d] = std::max(most[d], at(c)[d]);
      }
    double size = 0;
    for (std::size_t d = 0; d < 3; ++d) size = std::max(size, most[d] - least[d]);
    Point out{};
    if (!(size > 0)) return out;
    // A number that people can read is as good as the middle itself.
    const double unit = std::ldexp(1.0, std::ilogb(size) - 2);
    for (std::size_t d = 0; d < 3; ++d) {
      const double middle = std::round((least[d] / 2 + most[d] / 2) / unit) * unit;
      if (std::abs(middle) > size) out[d] = static_cast<double>(static_cast<float>(middle));
    }
    return out;
  }

  double error(const Point& offset) const {
    double out = 0;
    for (const std::uint32_t c : corners_)
      for (std::size_t d = 0; d < 3; ++d) {
        const double x = at(c)[d];
        out = std::max(out, std::abs(stored(x, offset[d]) + (offset[d] - x)));
      }
    return out;
  }

  bool isVisible(const Point& offset) const {
    std::size_t changed = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
      changed += changes(at(corners_[i]), at(corners_[next]), offset);
    }
    return changed > corners_.size() / 100;
  }

 private:
  const double* at(std::uint32_t corner) const {
    return &mesh_.positions[3 * std::size_t{mesh_.faceVertices[corner]}];
  }

  static double stored(double x, double offset) {
    return static_cast<double>(static_cast<float>(x - offset));
  }

  static bool changes(const double* a, const double* b, const Point& offset) {
    double length = 0, change = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double before = b[d] - a[d];
      const double now = stored(b[d], offset[d]) - stored(a[d], offset[d]);
      length = std::max(length, std::abs(before));
      change = std::max(change, std::abs(now - before));
    }
    return change > 1e-3 * length;
  }

  const PolygonMesh& mesh_;
  const std::vector<std::uint32_t>& corners_;
};

}  // namespace

Origin originOf(const PolygonMesh& mesh, const std::vector<std::uint32_t>& triangleCorners) {
  const Rounding rounding(mesh, triangleCorners);
  Origin out;
  out.isVisible = rounding.isVisible(out.offset);
  out.error = out.unmoved = rounding.error(out.offset);
  if (const Point offset = rounding.offset(); out.isVisible && offset != out.offset) {
    out.offset = offset;
    out.isVisible = rounding.isVisible(offset);
    out.error = rounding.error(offset);
  }
  return out;
}

}  // namespace gltf

std::string originNote(const PolygonMesh& mesh, const std::vector<std::uint32_t>& triangleCorners) {
  const gltf::Origin origin = gltf::originOf(mesh, triangleCorners);
  const std::string rest =
      "single precision, all that glTF has, moves vertices by up to " + withDigits(origin.error, 2);
  const std::string remedy = rest + ". Write OBJ or PLY to keep coordinates exactly";
  if (origin.offset == gltf::Origin().offset) return origin.isVisible ? remedy : "";
  std::string out =
      "the mesh is far from the origin, where single precision would move vertices by up to " +
      withDigits(origin.unmoved, 2) + ". So nodes are translated by (";
  for (std::size_t d = 0; d < 3; ++d) out += (d == 0 ? "" : ", ") + withDigits(origin.offset[d], 9);
  out += "), and positions are relative to that";
  return origin.isVisible ? out + "; " + rest + " still" : out;
}

}  // namespace abflat
