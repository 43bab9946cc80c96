#include "verify/measure_islands.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mesh/input_mesh.h"
#include "mesh/triangle_geometry.h"
#include "pack/pose.h"

namespace abflat {
namespace {

/// A triangle on the surface and in uv: the map's singular values, and both areas.
struct MappedTriangle {
  double onSurface = 0, inUv = 0;
  double larger = 0, smaller = 0;  ///< singular values
};

/// A triangle of the surface in its own plane: (0, 0), (length, 0) and (x, y).
struct InPlane {
  double length = 0, x = 0, y = 0;
};

InPlane inPlane(const std::vector<double>& positions, const TriangleVertices& v) {
  const Vec3 e = edgeVector(positions, v[0], v[1]), f = edgeVector(positions, v[0], v[2]);
  const double length = norm(e);
  if (!(length > 0)) return {};
  return {length, dot(e, f) / length, norm(cross(e, f)) / length};
}

/// `uv` in texels.
MappedTriangle mapped(const InPlane& plane, const std::array<double, 6>& uv) {
  const double px = uv[2] - uv[0], py = uv[3] - uv[1], qx = uv[4] - uv[0], qy = uv[5] - uv[1];
  MappedTriangle out;
  out.onSurface = plane.length * plane.y / 2;
  out.inUv = std::abs(px * qy - py * qx) / 2;
  if (!(out.onSurface > 0)) return out;
  const double ax = px / plane.length, ay = py / plane.length;
  const double bx = (qx - ax * plane.x) / plane.y, by = (qy - ay * plane.x) / plane.y;
  const double squares = ax * ax + ay * ay + bx * bx + by * by;
  const double twice = 2 * std::abs(ax * by - ay * bx);
  const double sum = std::sqrt(squares + twice);
  const double difference = std::sqrt(std::max(squares - twice, 0.0));
  out.larger = (sum + difference) / 2;
  out.smaller = out.larger > 0 ? twice / 2 / out.larger : 0;
  return out;
}

double stretchAt(const MappedTriangle& t, double scale) {
  const double a = t.larger / scale, b = t.smaller / scale;
  return (a * a + b * b + 1 / (a * a) + 1 / (b * b)) / 4;
}

double widthOf(const std::vector<PlanePoint>& points) {
  const Pose box = leastBoxPose(convexHull(points));
  return std::min(box.width, box.height);
}

class Measurer {
 public:
  Measurer(const PolygonMesh& mesh, const MappedTriangles& triangles, const AtlasSize& size)
      : mesh_(mesh), triangles_(triangles), size_(size), exponent_(exponentOf(mesh)) {
    positions_ = mesh.positions;
    for (double& x : positions_) x = std::ldexp(x, -exponent_);
  }

  LayoutMeasures run() {
    const IslandTriangles& inUv = triangles_.inUv;
    out_.densityOf.assign(triangles_.face.size(), kNotMeasured);
    out_.hasArea.assign(triangles_.face.size(), 0);
    out_.islands.resize(inUv.islands());
    for (std::uint32_t i = 0; i < inUv.islands(); ++i) measure(i);
    if (onSurface_ > 0) {
      out_.density = perUnit(std::sqrt(inUv_ / onSurface_));
      out_.stretch = stretch_ / stretched_;
      out_.conformalMean = conformal_ / stretched_;
    }
    return std::move(out_);
  }

 private:
  double perUnit(double texels) const { return std::ldexp(texels, -exponent_); }

  std::array<double, 6> inTexels(std::uint32_t t) const {
    std::array<double, 6> out;
    for (std::size_t k = 0; k < 6; ++k)
      out[k] =
          triangles_.inUv.uv[6 * std::size_t{t} + k] * (k % 2 == 0 ? size_.width : size_.height);
    return out;
  }

  void measure(std::uint32_t island) {
    const std::vector<std::uint32_t>& begin = triangles_.inUv.begin;
    IslandMeasures& own = out_.islands[island];
    std::vector<MappedTriangle> all;
    std::vector<PlanePoint> points;
    double covered = 0;
    for (std::uint32_t t = begin[island]; t < begin[island + 1]; ++t) {
      const std::array<double, 6> uv = inTexels(t);
      TriangleVertices v;
      for (std::size_t k = 0; k < 3; ++k) {
        v[k] = mesh_.faceVertices[triangles_.corners[t][k]];
        points.push_back({uv[2 * k], uv[2 * k + 1]});
      }
      out_.hasArea[t] = !isDegenerate(cornerAngles(positions_, v));
      all.push_back(out_.hasArea[t] ? mapped(inPlane(positions_, v), uv) : MappedTriangle());
      own.turning += doubleArea(uv.data()) / 2;
      own.area += std::abs(doubleArea(uv.data())) / 2;
      own.onSurface += all.back().onSurface;
      covered += all.back().inUv;
      takeDensity(t, all.back());
    }
    own.width = widthOf(points);
    inUv_ += covered;
    onSurface_ += own.onSurface;
    if (own.onSurface > 0 && covered > 0) takeStretch(all, std::sqrt(covered / own.onSurface), own);
  }

  void takeDensity(std::uint32_t t, const MappedTriangle& triangle) {
    if (!out_.hasArea[t]) return;
    const double density = perUnit(std::sqrt(triangle.inUv / triangle.onSurface));
    out_.densityOf[t] = density;
    if (!(triangle.inUv > 0)) return;
    if (!(out_.leastDensity.value <= density)) out_.leastDensity = {density, t};
    if (!(out_.mostDensity.value >= density)) out_.mostDensity = {density, t};
  }

  void takeStretch(const std::vector<MappedTriangle>& all, double scale, IslandMeasures& own) {
    own.density = perUnit(scale);
    double sum = 0, area = 0;
    for (const MappedTriangle& t : all) {
      if (!(t.smaller > 0)) continue;
      const double ratio = t.larger / t.smaller;
      area += t.onSurface;
      sum += stretchAt(t, scale) * t.onSurface;
      conformal_ += ratio * t.onSurface;
      if (!(out_.conformalMost >= ratio)) out_.conformalMost = ratio;
    }
    if (!(area > 0)) return;
    own.stretch = sum / area;
    stretch_ += sum;
    stretched_ += area;
  }

  const PolygonMesh& mesh_;
  const MappedTriangles& triangles_;
  const AtlasSize size_;
  const int exponent_;
  std::vector<double> positions_;
  LayoutMeasures out_;
  double inUv_ = 0, onSurface_ = 0, stretch_ = 0, stretched_ = 0, conformal_ = 0;
};

}  // namespace

LayoutMeasures measureIslands(const PolygonMesh& mesh, const MappedTriangles& triangles,
                              const AtlasSize& size) {
  return Measurer(mesh, triangles, size).run();
}

}  // namespace abflat
