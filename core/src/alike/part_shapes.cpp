#include "alike/part_shapes.h"

#include <algorithm>
#include <cmath>

#include "base/stable_order.h"

namespace abflat {
namespace {

/// A number that looks random but depends only on `x` (splitmix64).
std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

IdVector<PolygonCorner, std::uint32_t> valencesOf(const Cells& cells) {
  IdVector<PolygonCorner, std::uint32_t> out(cells.twin.size(), 0);
  const auto before = [&](PolygonCorner c) { return cells.twin[cells.prev(c)]; };
  const auto after = [&](PolygonCorner c) {
    const PolygonCorner o = cells.twin[c];
    return o.exists() ? cells.next(o) : o;
  };
  for (const PolygonCorner c : out.ids()) {
    if (out[c] > 0) continue;
    PolygonCorner first = c;
    for (PolygonCorner i = before(c); i.exists() && i != c; i = before(i)) first = i;
    std::uint32_t count = 1;
    for (PolygonCorner i = after(first); i.exists() && i != first; i = after(i)) ++count;
    out[first] = count;
    for (PolygonCorner i = after(first); i.exists() && i != first; i = after(i)) out[i] = count;
  }
  return out;
}

/// Color refinement after Weisfeiler and Leman. Sums do not depend on the order, so colors stay
/// when a part is mirrored or renumbered.
IdVector<PolygonFace, std::uint64_t> colorsOf(
    const Cells& cells, const IdVector<PolygonCorner, std::uint32_t>& valence) {
  constexpr int kRounds = 4;
  IdVector<PolygonFace, std::uint64_t> color(cells.part.size(), 0), next;
  for (const PolygonFace f : color.ids()) {
    std::uint64_t sum = scrambled(cells.faceMark[f]) + cells.size(f);
    for (const PolygonCorner c : cells.corners(f))
      sum += scrambled(2 * std::uint64_t{cells.edgeMark[c]} + cells.twin[c].exists()) +
             scrambled(~std::uint64_t{valence[c]});
    color[f] = scrambled(sum);
  }
  for (int round = 0; round < kRounds; ++round) {
    next = color;
    for (const PolygonFace f : color.ids()) {
      for (const PolygonCorner c : cells.corners(f))
        if (const PolygonCorner o = cells.twin[c]; o.exists())
          next[f] += scrambled(color[cells.face[o]] + cells.edgeMark[c]);
      next[f] = scrambled(next[f]);
    }
    color.raw().swap(next.raw());
  }
  return color;
}

void listFaces(const Cells& cells, PartShapes& out) {
  out.begin.assign(cells.parts + 1, 0);
  for (const PartId part : cells.part)
    if (part.exists()) ++out.begin[PartId(part + 1)];
  for (std::size_t i = 0; i < cells.parts; ++i) out.begin[PartId(i + 1)] += out.begin[PartId(i)];
  IdVector<PartId, std::uint32_t> next = out.begin;
  out.faces.resize(out.begin.back());
  for (const PolygonFace f : cells.part.ids())
    if (cells.part[f].exists()) out.faces[next[cells.part[f]]++] = f;
}

template <class See>
void forCorners(const Cells& cells, const PartShapes& shapes, PartId i, const See& see) {
  for (const PolygonFace f : shapes.facesOf(i))
    for (const PolygonCorner c : cells.corners(f)) see(c);
}

void measure(const Cells& cells, const PartShapes& shapes, PartId i, PartShape& out) {
  std::size_t corners = 0;
  forCorners(cells, shapes, i, [&](PolygonCorner c) {
    for (std::size_t d = 0; d < 3; ++d) out.centre[d] += cells.at(c)[d];
    ++corners;
  });
  const auto count = static_cast<double>(corners);
  for (double& x : out.centre) x /= count;
  forCorners(cells, shapes, i, [&](PolygonCorner c) {
    const double distance = distanceBetween(cells.at(c), out.centre.data());
    out.radius = std::max(out.radius, distance);
    out.meanDistance += distance / count;
    out.meanEdge += distanceBetween(cells.at(c), cells.at(cells.next(c))) / count;
  });
}

}  // namespace

double distanceBetween(const double* a, const double* b) {
  return norm(Vec3{a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

bool PartShapes::mayBeAlike(PartId a, PartId b) const {
  const PartShape &p = part[a], &q = part[b];
  // If no vertex is off by more than the tolerance, neither is the centre.
  const double most = 2 * kAlikeTolerance * p.radius;
  return p.key == q.key && p.faces == q.faces && std::abs(p.radius - q.radius) <= most &&
         std::abs(p.meanDistance - q.meanDistance) <= most &&
         std::abs(p.meanEdge - q.meanEdge) <= most;
}

PartShapes shapesOf(const Cells& cells, const IdVector<PartId, std::uint8_t>& isLeftOut) {
  PartShapes out;
  out.valence = valencesOf(cells);
  out.color = colorsOf(cells, out.valence);
  listFaces(cells, out);
  out.part.resize(cells.parts);
  for (const PartId i : out.part.ids()) {
    if (isLeftOut[i]) continue;
    PartShape& shape = out.part[i];
    shape.faces = static_cast<std::uint32_t>(out.facesOf(i).size());
    for (const PolygonFace f : out.facesOf(i)) shape.key += scrambled(out.color[f]);
  }
  const auto keyOf = [&](std::uint32_t i) { return out.part[PartId(i)].key; };
  const std::vector<std::uint32_t> order = stableOrder(
      cells.parts, [&](std::uint32_t a, std::uint32_t b) { return keyOf(a) < keyOf(b); });
  const auto isSame = [&](std::size_t i, std::size_t k) {
    return k < order.size() && keyOf(order[i]) == keyOf(order[k]);
  };
  for (std::size_t i = 0; i < order.size(); ++i)
    if (const PartId part(order[i]); !isLeftOut[part] && (isSame(i, i - 1) || isSame(i, i + 1)))
      measure(cells, out, part, out.part[part]);
  return out;
}

}  // namespace abflat
