#include "pin/pinned_layout.h"

#include <algorithm>

#include "mesh/triangle_geometry.h"
#include "pin/relax_conformally.h"

namespace abflat {
namespace {

/// (u, v) -> (a x - b y, b x + a y) + to, with (x, y) = (u, v) - from.
struct Similarity {
  double a = 1, b = 0;
  Point2 from{0, 0}, to{0, 0};

  Point2 operator()(const Point2& p) const {
    const double x = p[0] - from[0], y = p[1] - from[1];
    return {a * x - b * y + to[0], b * x + a * y + to[1]};
  }
};

/// Maps middle to middle; a + ib = sum conj(z) w / sum |z|^2 for vectors z and w from the middles.
Similarity bestSimilarity(const std::vector<double>& uv, const std::vector<ChartPin>& pins) {
  Similarity s;
  const auto n = static_cast<double>(pins.size());
  for (const ChartPin& p : pins) {
    const Point2 from = pointAt(uv, p.vertex);
    for (std::size_t d = 0; d < 2; ++d) {
      s.from[d] += from[d] / n;
      s.to[d] += p.uv[d] / n;
    }
  }
  double a = 0, b = 0, square = 0;
  for (const ChartPin& p : pins) {
    const Point2 from = pointAt(uv, p.vertex);
    const double x = from[0] - s.from[0], y = from[1] - s.from[1];
    const double u = p.uv[0] - s.to[0], v = p.uv[1] - s.to[1];
    a += x * u + y * v;
    b += x * v - y * u;
    square += x * x + y * y;
  }
  if (!(square > 0)) return s;  // a layout without extent is not scaled
  s.a = a / square;
  s.b = b / square;
  return s;
}

}  // namespace

PinnedLayout pinLayout(const FlatRegion& region, const std::vector<double>& angles,
                       const std::vector<double>& uv, const std::vector<ChartPin>& pins,
                       const PinOptions& options) {
  PinnedLayout out;
  out.uv = uv;
  out.memory.allowed = options.allowedBytes;
  const Similarity similarity = bestSimilarity(uv, pins);
  for (std::size_t v = 0; v < uv.size() / 2; ++v) setPoint(out.uv, v, similarity(pointAt(uv, v)));
  if (pins.size() > 2) {
    std::vector<double> correction(uv.size(), 0);
    std::vector<ChartVertex> pinned;
    for (const ChartPin& p : pins) {
      const Point2 now = pointAt(out.uv, p.vertex);
      const Point2 by{p.uv[0] - now[0], p.uv[1] - now[1]};
      setPoint(correction, p.vertex, by);
      pinned.push_back(p.vertex);
      out.deviation = std::max(out.deviation, norm(by[0], by[1]));
    }
    out.isSolved = relaxConformally(region, angles, pinned, correction, out.memory, options.pool);
    if (out.isSolved)
      for (std::size_t i = 0; i < uv.size(); ++i) out.uv[i] += correction[i];
  }
  for (const ChartPin& p : pins) setPoint(out.uv, p.vertex, p.uv);
  return out;
}

}  // namespace abflat
