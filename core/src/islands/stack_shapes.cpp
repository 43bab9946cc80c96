#include "islands/stack_shapes.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/stable_order.h"
#include "islands/row_spans.h"

namespace abflat {
namespace {

/// The triangles of a shape, each once, all counter-clockwise.
std::vector<std::uint32_t> counterClockwise(const PackShape& shape) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t t = 0; t < shape.triangles.size(); t += 3) {
    std::array<std::uint32_t, 3> v{};
    std::array<double, 6> uv{};
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = shape.triangles[t + k];
      std::copy_n(&shape.uv[2 * std::size_t{v[k]}], 2, &uv[2 * k]);
    }
    if (doubleArea(uv.data()) < 0) std::swap(v[0], v[1]);
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    triangles.push_back(v);
  }
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  std::vector<std::uint32_t> out;
  for (const auto& v : triangles) out.insert(out.end(), v.begin(), v.end());
  return out;
}

}  // namespace

std::vector<IslandStack> listStacks(const IslandTriangles& triangles,
                                    const std::vector<std::uint32_t>& first,
                                    const std::vector<double>& surfaceArea) {
  std::vector<IslandStack> out;
  std::vector<std::uint32_t> stackOf(first.size());
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) out.emplace_back();
    stackOf[i] = first[i] == i ? static_cast<std::uint32_t>(out.size() - 1) : stackOf[first[i]];
    IslandStack& stack = out[stackOf[i]];
    stack.islands.push_back(i);
    stack.surfaceArea += surfaceArea[i];
    const UvBox box = triangles.box(i);
    stack.box.add(box.low.data());
    stack.box.add(box.high.data());
  }
  for (IslandStack& stack : out) {
    RowSpans spans(stack.box.low[1], stack.box.high[1]);
    for (const std::uint32_t i : stack.islands) {
      spans.cover(triangles.of(i), triangles.count(i));
      for (const double* t = triangles.of(i); t != triangles.of(i + 1); t += 6)
        stack.uvArea += std::abs(doubleArea(t)) / 2;
    }
    stack.coveredArea = spans.area();
  }
  sortStably(out, [](const IslandStack& a, const IslandStack& b) {
    return std::tie(a.box.low, a.box.high, a.uvArea) < std::tie(b.box.low, b.box.high, b.uvArea);
  });
  return out;
}

double setFactors(IslandSizes sizes, std::vector<IslandStack>& stacks) {
  double onSurface = 0, inUv = 0;
  for (const IslandStack& stack : stacks) {
    onSurface += stack.surfaceArea;
    inUv += stack.uvArea / stack.aspect;
  }
  const double mean = areaRatio(onSurface, inUv);
  for (IslandStack& stack : stacks) {
    const double own = areaRatio(stack.surfaceArea, stack.uvArea / stack.aspect);
    const bool isEven = sizes == IslandSizes::Even && own > 0;
    const double area = isEven ? own : mean;
    stack.factor = area > 0 && !stack.isFixed ? std::sqrt(area) : 1;
  }
  return mean > 0 ? std::sqrt(mean) : 1;
}

PackShape shapeOf(const IslandStack& stack, const IslandTriangles& triangles) {
  std::vector<std::array<double, 2>> points;  // of corners
  for (const std::uint32_t i : stack.islands)
    for (const double* p = triangles.of(i); p != triangles.of(i + 1); p += 2)
      points.push_back({p[0], p[1]});
  const auto count = points.size();
  const std::vector<std::uint32_t> order =
      stableOrder(count, [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  PackShape out;
  out.isPosed = true;
  out.isFixed = stack.isFixed;
  const auto placed = [&](double x, std::size_t d) {
    return stack.isFixed ? x : stack.placed(x, d);
  };
  out.coveredArea = stack.coveredArea * stack.factor * stack.factor / stack.aspect;
  out.triangles.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto& p = points[order[k]];
    if (k == 0 || p != points[order[k - 1]])
      for (std::size_t d = 0; d < 2; ++d) out.uv.push_back(placed(p[d], d));
    out.triangles[order[k]] = static_cast<std::uint32_t>(out.uv.size() / 2 - 1);
  }
  out.triangles = counterClockwise(out);
  return out;
}

}  // namespace abflat
