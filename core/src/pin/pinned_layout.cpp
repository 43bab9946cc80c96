#include "pin/pinned_layout.h"

#include <algorithm>

#include "mesh/triangle_geometry.h"
#include "pin/conformal_energy.h"

namespace abflat {
namespace {

/// (u, v) -> (a x - b y, b x + a y) + to, with (x, y) = (u, v) - from.
struct Similarity {
  double a = 1, b = 0;
  double fromU = 0, fromV = 0, toU = 0, toV = 0;

  void apply(double* p) const {
    const double x = p[0] - fromU, y = p[1] - fromV;
    p[0] = a * x - b * y + toU;
    p[1] = b * x + a * y + toV;
  }
};

/// Middle to middle; a + ib = sum conj(z) w / sum |z|^2 for vectors z and w from there.
Similarity bestSimilarity(const std::vector<double>& uv, const std::vector<ChartPin>& pins) {
  Similarity s;
  const auto n = static_cast<double>(pins.size());
  for (const ChartPin& p : pins) {
    s.fromU += uv[2 * p.vertex] / n;
    s.fromV += uv[2 * p.vertex + 1] / n;
    s.toU += p.u / n;
    s.toV += p.v / n;
  }
  double a = 0, b = 0, square = 0;
  for (const ChartPin& p : pins) {
    const double x = uv[2 * p.vertex] - s.fromU, y = uv[2 * p.vertex + 1] - s.fromV;
    const double u = p.u - s.toU, v = p.v - s.toV;
    a += x * u + y * v;
    b += x * v - y * u;
    square += x * x + y * y;
  }
  if (!(square > 0)) return s;  // a layout without extent stays so
  s.a = a / square;
  s.b = b / square;
  return s;
}

}  // namespace

PinnedLayout pinLayout(const DiskChart& chart, const std::vector<double>& angles,
                       const std::vector<double>& uv, const std::vector<ChartPin>& pins,
                       const PinOptions& options) {
  PinnedLayout out;
  out.uv = uv;
  out.memory.allowed = options.allowedBytes;
  const Similarity similarity = bestSimilarity(uv, pins);
  for (std::size_t i = 0; i < uv.size(); i += 2) similarity.apply(&out.uv[i]);
  if (pins.size() > 2) {
    std::vector<double> correction(uv.size(), 0);
    std::vector<std::uint32_t> pinned;
    for (const ChartPin& p : pins) {
      const double u = p.u - out.uv[2 * p.vertex], v = p.v - out.uv[2 * p.vertex + 1];
      correction[2 * p.vertex] = u;
      correction[2 * p.vertex + 1] = v;
      pinned.push_back(p.vertex);
      out.deviation = std::max(out.deviation, norm(u, v));
    }
    out.isSolved = relaxConformally(conformalEnergy(chart, angles), pinned, correction, out.memory,
                                    options.pool);
    if (out.isSolved)
      for (std::size_t i = 0; i < uv.size(); ++i) out.uv[i] += correction[i];
  }
  for (const ChartPin& p : pins) {
    out.uv[2 * p.vertex] = p.u;
    out.uv[2 * p.vertex + 1] = p.v;
  }
  return out;
}

}  // namespace abflat
