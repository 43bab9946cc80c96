#include "unwrap/small_charts.h"

#include <algorithm>

#include "base/stable_order.h"
#include "unwrap/expected_density.h"
#include "unwrap/stretch.h"

namespace abflat {
namespace {

/// Consecutive edges of a chart's outline with the same chart on their other side.
struct Border {
  CutChartId other;
  std::size_t first = 0, count = 0;  ///< on the outline
  double cost = 0;                   ///< of the seam
};

/// What lies along the outlines of charts.
class Borders {
 public:
  explicit Borders(const OpenSurface& open)
      : open_(open), cut_(cutAlong(open.mesh, open.seams)), next_(cut_.corners().size()) {
    for (const CutChartId i : cut_.charts.ids()) {
      if (!cut_.charts[i].isDisk()) continue;
      const BoundaryLoop loop = cut_.outline(i);
      for (const BoundaryIndex k : loop.ids()) next_[loop[k]] = loop[nextAlong(k, loop.size())];
    }
  }

  const CutSurface& cut() const { return cut_; }

  /// Twice the area by the length of the outline: of a strip, how wide it is.
  double width(CutChartId i) const {
    double length = 0;
    for (const SurfaceCorner h : cut_.outline(i)) length += open_.mesh.length[h];
    return length > 0 ? 2 * cut_.charts[i].area / length : 0;
  }

  /// The dearest one where the seam may be closed, which makes one disk of two. No edges: none.
  template <class IsAllowed>
  Border dearest(CutChartId i, const IsAllowed& isAllowed) const {
    Border best, run;
    const BoundaryLoop loop = cut_.outline(i);
    const std::size_t size = loop.size(), begin = firstEnd(loop);
    SurfaceCorner last;
    for (std::size_t k = begin; k < begin + size; ++k) {
      const SurfaceCorner h = loop[BoundaryIndex(k % size)];
      if (!canClose(h)) continue;
      if (!last.exists() || !goesOn(last, h))
        run = {cut_.chartOf(open_.mesh.twin[h]), k % size, 0, 0};
      ++run.count;
      run.cost += open_.mesh.cost[h];
      last = h;
      if (run.cost > best.cost && isAllowed(run.other)) best = run;
    }
    // A sphere is no disk: where two charts share all of their outlines, a slit stays.
    if (best.count == size && goesOn(last, loop[BoundaryIndex(best.first)])) --best.count;
    return best;
  }

 private:
  bool canClose(SurfaceCorner h) const {
    const SeamMesh& mesh = open_.mesh;
    return mesh.isOnSurface(h) && !(h < open_.given.size() && open_.given[h]) &&
           cut_.chartOf(mesh.twin[h]) != cut_.chartOf(h);
  }

  /// Whether the second edge follows the first along both outlines, in opposite directions.
  bool goesOn(SurfaceCorner h, SurfaceCorner following) const {
    return canClose(h) && next_[h] == following &&
           next_[open_.mesh.twin[following]] == open_.mesh.twin[h];
  }

  /// Where along the loop a border may begin.
  std::size_t firstEnd(const BoundaryLoop& loop) const {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const SurfaceCorner h = loop[BoundaryIndex(k)];
      if (!canClose(h) || !goesOn(loop[BoundaryIndex((k + loop.size() - 1) % loop.size())], h))
        return k;
    }
    return 0;
  }

  const OpenSurface& open_;
  const CutSurface cut_;
  IdVector<SurfaceCorner, SurfaceCorner> next_;  ///< along an outline
};

bool isExact(const FlatChart& chart) {
  constexpr double kExact = 1e-6;
  return chart.distortion.symmetricDirichlet <= 1 + kExact;
}

}  // namespace

Seams SmallCharts::join(const LaidCharts& charts, const UnwrapOptions& options, OpenSurface& open) {
  constexpr double kShare = 1e-3, kTexels = 8;
  constexpr std::size_t kMostTriangles = 50'000;  // of a neighbour that is laid out anew
  open.seams.resize(open.mesh.twin.size(), 0);
  const Borders borders(open);
  const CutSurface& cut = borders.cut();
  const double area = open.mesh.totalArea();
  const double least = kTexels / expectedDensity(options, area, open.unit);
  enum class Role : std::uint8_t { None, Guest, Host };
  IdVector<CutChartId, Role> role(cut.charts.size(), Role::None);
  Seams before = open.seams;
  joined_.clear();
  const auto isSmallest = [&](std::uint32_t a, std::uint32_t b) {
    return cut.charts[CutChartId(a)].area < cut.charts[CutChartId(b)].area;
  };
  for (const std::uint32_t k : stableOrder(cut.charts.size(), isSmallest)) {
    const CutChartId i(k);
    const CutSurface::Chart& chart = cut.charts[i];
    if (role[i] != Role::None || !chart.isDisk() || open.mesh.isFilling(chart.firstTriangle) ||
        charts.flat[charts.set.ofTriangle[chart.firstTriangle]].isFixed ||
        (chart.area >= kShare * area && borders.width(i) >= least))
      continue;
    const auto pairWith = [&](CutChartId j) {
      return Pair{chart.firstTriangle, cut.charts[j].firstTriangle};
    };
    const Border border = borders.dearest(i, [&](CutChartId j) {
      return role[j] != Role::Guest && (role[j] == Role::None || isFirst_) &&
             cut.charts[j].isDisk() && cut.charts[j].triangles <= kMostTriangles &&
             !isRefused(pairWith(j));
    });
    if (border.count == 0) continue;
    role[i] = Role::Guest;
    role[border.other] = Role::Host;
    joined_.push_back(pairWith(border.other));
    const BoundaryLoop loop = cut.outline(i);
    for (std::size_t n = 0; n < border.count; ++n) {
      const SurfaceCorner h = loop[BoundaryIndex((border.first + n) % loop.size())];
      open.seams[h] = open.seams[open.mesh.twin[h]] = 0;
    }
  }
  return joined_.empty() ? Seams() : before;
}

IdVector<ChartId, std::uint8_t> SmallCharts::refused(const LaidCharts& before,
                                                     const LaidCharts& now,
                                                     const UnwrapOptionValues& options,
                                                     const Mirror& mirror) {
  IdVector<ChartId, std::uint32_t> parts(now.set.size(), 0);
  IdVector<ChartId, std::uint8_t> wasExact(now.set.size(), 1), isBad;
  const auto nowOf = [&](ChartId i) {
    return now.set.ofTriangle[before.set.topology(i).triangles.front()];
  };
  for (const ChartId i : before.set.ids()) {
    ++parts[nowOf(i)];
    wasExact[nowOf(i)] &= isExact(before.flat[i]);
  }
  for (const ChartId i : now.set.ids()) {
    const FlatChart& flat = now.flat[i];
    isBad.push_back(parts[i] > 1 &&
                    (!flat.problem.empty() || isStretched(flat, now.set.leewayOf(i), options) ||
                     (wasExact[i] && !isExact(flat))));
  }
  if (mirror) spread(mirror, now.set, isBad);
  for (const Pair& pair : joined_) {
    const ChartId i = now.set.ofTriangle[pair.first];
    // Where one of several spoils it, each gets another chance alone, unless its image would not.
    if (isBad[i] && (parts[i] == 2 || mirror)) refused_.push_back(pair);
  }
  isFirst_ = false;
  IdVector<ChartId, std::uint8_t> out;
  for (const ChartId i : before.set.ids()) out.push_back(isBad[nowOf(i)]);
  return out;
}

/// To the images of what is joined.
void SmallCharts::spread(const Mirror& mirror, const ChartSet& set,
                         IdVector<ChartId, std::uint8_t>& isBad) const {
  for (const Pair& pair : joined_)
    for (int k = 0; k < 3; ++k) {
      const SurfaceCorner image = mirror.image[cornerOf(pair.first, k)];
      if (!image.exists() || !(triangleOf(image) < set.ofTriangle.size())) continue;
      const ChartId there = set.ofTriangle[triangleOf(image)];
      isBad[set.ofTriangle[pair.first]] |= isBad[there];
    }
}

}  // namespace abflat
