#include "pack/texels.h"

#include <algorithm>
#include <cmath>

namespace abflat::test {
namespace {

constexpr double kNear = 1e-6;

struct Corner {
  double x, y;
};

/// A closed square and a closed triangle are disjoint if a line along a side of one of them
/// separates them.
bool touches(const Corner (&t)[3], int x, int y) {
  const Corner square[] = {
      {x + 0.0, y + 0.0}, {x + 1.0, y + 0.0}, {x + 1.0, y + 1.0}, {x + 0.0, y + 1.0}};
  for (int e = 0; e < 3; ++e) {
    const Corner a = t[e], b = t[(e + 1) % 3];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length == 0) continue;
    const double nx = (a.y - b.y) / length, ny = (b.x - a.x) / length;
    double least = 1e300, most = -1e300, from = 1e300, to = -1e300;
    for (const Corner& c : t) {
      least = std::min(least, nx * c.x + ny * c.y);
      most = std::max(most, nx * c.x + ny * c.y);
    }
    for (const Corner& c : square) {
      from = std::min(from, nx * c.x + ny * c.y);
      to = std::max(to, nx * c.x + ny * c.y);
    }
    if (from > most + kNear || to < least - kNear) return false;
  }
  return true;
}

}  // namespace

Texels touchedTexels(const std::vector<double>& uv, const std::vector<std::uint32_t>& triangles,
                     const AtlasSize& resolution) {
  Texels out;
  for (std::size_t f = 0; f + 2 < triangles.size(); f += 3) {
    Corner t[3];
    for (std::size_t k = 0; k < 3; ++k)
      t[k] = {uv[2 * triangles[f + k]] * resolution.width,
              uv[2 * triangles[f + k] + 1] * resolution.height};
    const auto range = [&t](double Corner::*x) {
      const auto [least, most] = std::minmax({t[0].*x, t[1].*x, t[2].*x});
      return std::make_pair(static_cast<int>(std::ceil(least - kNear)) - 1,
                            static_cast<int>(std::floor(most + kNear)));
    };
    const auto [left, right] = range(&Corner::x);
    const auto [bottom, top] = range(&Corner::y);
    for (int y = bottom; y <= top; ++y)
      for (int x = left; x <= right; ++x)
        if (touches(t, x, y)) out.emplace_back(x, y);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::vector<double> placed(const PackShape& shape, const Placement& placement, bool toSingle) {
  std::vector<double> out;
  for (std::size_t i = 0; i + 1 < shape.uv.size(); i += 2) {
    const double u = placement.u(&shape.uv[i]) + placement.column();
    const double v = placement.v(&shape.uv[i]) + placement.row();
    out.push_back((toSingle ? static_cast<double>(static_cast<float>(u)) : u) - placement.column());
    out.push_back((toSingle ? static_cast<double>(static_cast<float>(v)) : v) - placement.row());
  }
  return out;
}

std::string complaint(const std::vector<PackShape>& shapes, const Packing& packing,
                      const PackOptions& options, bool toSingle) {
  const auto [width, height] = options.resolution;
  const int padding = options.padding, margin = marginOf(options);
  std::vector<std::vector<std::int32_t>> owner(
      packing.tiles, std::vector<std::int32_t>(static_cast<std::size_t>(width * height), -1));
  const auto at = [&](const Placement& p, int x, int y) -> std::int32_t& {
    return owner[p.tile][static_cast<std::size_t>(y * options.resolution.width + x)];
  };
  std::vector<Texels> touched(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Placement& p = packing.placements[i];
    const std::string chart = "chart " + std::to_string(i);
    if (p.tile >= packing.tiles) return chart + " is in no tile";
    const std::vector<double> uv = placed(shapes[i], p, toSingle);
    for (const double x : uv)
      if (!(x >= 0 && x <= 1)) return chart + " leaves its tile";
    touched[i] = touchedTexels(uv, shapes[i].triangles, options.resolution);
    for (const auto& [x, y] : touched[i]) {
      // The line that closes the last texel belongs to no texel after it.
      if (x < 0 || y < 0 || x >= width || y >= height) {
        if (margin > 0) return chart + " touches the border";
        continue;
      }
      if (at(p, x, y) >= 0) return chart + " shares a texel with " + std::to_string(at(p, x, y));
      at(p, x, y) = static_cast<std::int32_t>(i);
    }
  }
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (const auto& [x, y] : touched[i]) {
      if (std::min(x, y) < margin || x >= width - margin || y >= height - margin)
        return "chart " + std::to_string(i) + " is too near to the border";
      for (int v = std::max(y - padding, 0); v <= std::min(y + padding, height - 1); ++v)
        for (int u = std::max(x - padding, 0); u <= std::min(x + padding, width - 1); ++u) {
          const std::int32_t other = at(packing.placements[i], u, v);
          if (other >= 0 && other != static_cast<std::int32_t>(i))
            return "chart " + std::to_string(i) + " is too near to " + std::to_string(other);
        }
    }
  return {};
}

}  // namespace abflat::test
