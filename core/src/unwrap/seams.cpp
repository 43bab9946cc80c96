#include "unwrap/seams.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/long_sum.h"
#include "base/number_text.h"
#include "cut/filled_table.h"
#include "hole/fill_holes.h"
#include "mesh/triangle_geometry.h"
#include "refine/refine.h"
#include "seam/extract_charts.h"
#include "seam/find_seams.h"
#include "seam/halve_charts.h"
#include "seam/log_scale.h"
#include "seam/plates.h"
#include "seam/prediction.h"
#include "seam/seam_value.h"
#include "seam/vary_costs.h"
#include "unwrap/expected_density.h"

namespace abflat {
namespace {

/// The given seams, without those inside fixed islands, plus the borders of these islands.
Seams withBorders(const Seams& given, const FixedTriangles& fixed) {
  if (fixed.isFixed.empty()) return given;
  Seams out = fixed.borders;
  for (const SurfaceCorner h : out.ids())
    if (given[h] && !fixed.isFixed[triangleOf(h)]) out[h] = 1;
  return out;
}

/// Opens the surface along the given seams, so that the holes of its charts show, and fills these
/// holes. Without holes the surface stays as it is, so that its elimination order does not depend
/// on the given seams. The result's seams are those given that are not on its boundary.
OpenSurface openAndFill(const UncutSurface& uncut, const AskedCuts& asked,
                        const UnwrapOptions& options, const Pulse& pulse) {
  const Surface& surface = uncut.surface;
  const PolygonMesh& mesh = uncut.welded.mesh;
  Seams given = withBorders(asked.seams, uncut.fixed);
  CornerTable table = surface.table;
  for (const SurfaceCorner h : given.ids())
    if (given[h]) table.twin[h] = SurfaceCorner();
  const auto meshOf = [&](const CornerTable& t, const Fans& fans) {
    return makeSeamMesh(mesh.positions, t, fans, surface.triangulation.isDiagonal,
                        asked.scales.ofTriangle, asked.breaks, options.seamCosts, asked.upAxis,
                        pulse);
  };
  const bool isAny = std::find(given.begin(), given.end(), 1) != given.end();
  Fans fans = isAny ? findFans(table, mesh.vertexCount()) : surface.fans;
  OpenSurface out;
  out.mesh = meshOf(table, fans);
  fillHoles(options.fillHoles, uncut.fixed.isFixed, out.mesh, pulse);
  if (isAny && out.mesh.hole.empty() && uncut.fixed.isFixed.empty() &&
      asked.scales.ofTriangle.empty()) {
    fans = surface.fans;
    out.mesh = meshOf(surface.table, fans);
    out.seams = given;
  }
  out.inputVertex = std::move(fans.inputVertex);
  out.given = std::move(given);
  return out;
}

/// The unit of the seam finder's mesh, in that of the welded one; derived from the longest edge.
double unitOf(const WeldedMesh& welded, const OpenSurface& open) {
  const auto longest = std::max_element(open.mesh.length.begin(), open.mesh.length.end());
  if (longest == open.mesh.length.end() || !(*longest > 0)) return 1;
  const SurfaceCorner h(longest - open.mesh.length.begin());
  const InputVertex tail = open.inputVertex[open.mesh.tail(h)];
  const InputVertex head = open.inputVertex[open.mesh.head(h)];
  return norm(edgeVector(welded.mesh.positions, tail, head)) / *longest;
}

SeamOptions seamOptions(const UnwrapOptions& options, const OpenSurface& open, ThreadPool& pool,
                        std::function<bool()> keepsOn, int variant = 0) {
  SeamOptions out;
  out.variant = variant;
  out.isAuto = options.seams.isAuto;
  out.maxStretch = stretchBeforeRefining(options.maxStretch, Energy(options.balance));
  if (options.seamCosts == SeamCosts::Length) out.prices = SeamPrices::none();
  out.symmetricSeams = options.symmetricSeams;
  out.fillHoles = options.fillHoles;
  constexpr double kSpeckTexels = 16;
  out.speck = kSpeckTexels / expectedDensity(options, open.mesh.totalArea(), open.unit);
  if (options.udim)  // each chart has to fit a tile
    out.longest = (options.resolution - 2 * options.padding) / options.texelDensity / open.unit;
  out.pool = &pool;
  out.keepsOn = std::move(keepsOn);
  return out;
}

bool isGiven(const OpenSurface& open, SurfaceCorner h) {
  return h < open.given.size() && open.given[h];
}

/// Seams that separate charts. Slits within a chart do not count, unless they are given.
Seams seamsBetween(const CutSurface& s, const OpenSurface& open) {
  Seams out = open.seams;
  for (const SurfaceCorner h : out.ids()) {
    const SurfaceCorner o = open.mesh.twin[h];
    if (o.exists() && s.chartOf(h) == s.chartOf(o) && !isGiven(open, h)) out[h] = 0;
  }
  return out;
}

/// Finds new seams within the wanted charts of `surface`, starting from those that were found
/// before. False if nothing has changed.
bool findWithin(const CutSurface& surface, const IdVector<CutChartId, std::uint8_t>& isWanted,
                SeamOptions options, OpenSurface& open, SeamReport& found) {
  const SeamPart part = extractCharts(open.mesh, surface, isWanted);
  const bool hasRanks = !open.eliminationRanks.empty();
  if (hasRanks) options.eliminationRanks = part.ofVertices(open.eliminationRanks);
  options.mirror = open.mirror.ofPart(part);
  open.seams.resize(open.mesh.twin.size(), 0);
  open.found.resize(open.mesh.twin.size(), 0);
  Seams given;
  for (const SurfaceCorner h : part.wholeHalfEdge) {
    given.push_back(open.seams[h] && isGiven(open, h));
    options.first.push_back(open.found[h]);
  }
  const Seams seams = findSeams(part.mesh, std::move(given), options, &found);
  bool isAny = false;
  for (const SurfaceCorner i : seams.ids()) {
    const SurfaceCorner h = part.wholeHalfEdge[i];
    if (!part.mesh.twin[i].exists()) continue;
    isAny = isAny || open.seams[h] != seams[i];
    open.seams[h] = seams[i];
    open.found[h] = found.found[i];
  }
  open.eliminationRanks.resize(open.mesh.vertexCount(), 0);
  open.scale.resize(open.mesh.vertexCount(), 0);
  open.foundScale.resize(open.mesh.vertexCount(), 0);
  for (const SurfaceVertex i : found.eliminationRanks.ids()) {
    const SurfaceVertex v = part.wholeVertex[i];
    // A chart must be solved in the same order whenever it is found.
    if (!hasRanks) open.eliminationRanks[v] = found.eliminationRanks[i];
    open.scale[v] = found.scale[i];
    open.foundScale[v] = found.foundScale[i];
  }
  return isAny;
}

/// Restores the seams of a chart to their length before shortening; false if they already have it.
bool restore(const CutSurface& s, CutChartId chart, OpenSurface& open) {
  bool isAny = false;
  for (const SurfaceTriangle f : s.trianglesOf(chart))
    for (const SurfaceCorner h : cornersOf(f)) {
      const SurfaceVertex v = open.mesh.tail(h);
      if (!s.isBoundary[s.tail(h)]) open.scale[v] = open.foundScale[v];
      if (open.seams[h] || !open.found[h] || !open.mesh.twin[h].exists()) continue;
      open.seams[h] = isAny = true;
    }
  return isAny;
}

bool isAlone(const SeamMesh& mesh, SurfaceTriangle f) {
  for (const SurfaceCorner h : cornersOf(f))
    if (mesh.twin[h].exists()) return false;
  return true;
}

bool areMostAlone(const SeamMesh& mesh) {
  std::uint32_t alone = 0;
  for (const SurfaceTriangle f : mesh.triangles()) alone += isAlone(mesh, f);
  return alone > mesh.triangleCount() / 2;
}

/// Leaves out fixed islands, which must not be cut and may have holes; their borders are open. Also
/// leaves out isolated triangles if there are many, since they need no search.
void findAround(const IdVector<SurfaceTriangle, std::uint8_t>& isFixed, const SeamOptions& options,
                OpenSurface& open, SeamReport& found) {
  if (isFixed.empty() && !areMostAlone(open.mesh)) {
    open.seams = findSeams(open.mesh, std::move(open.seams), options, &found);
    open.eliminationRanks = std::move(found.eliminationRanks);
    open.scale = std::move(found.scale);
    open.found = std::move(found.found);
    open.foundScale = std::move(found.foundScale);
    open.mirror = std::move(found.mirror);
    open.otherwise = std::move(found.otherwise);
    return;
  }
  const CutSurface islands = cutAlong(open.mesh, Seams(open.mesh.twin.size(), 0));
  IdVector<CutChartId, std::uint8_t> isWanted;
  for (const CutSurface::Chart& chart : islands.charts)
    isWanted.push_back(chart.triangles > 1 && (isFixed.empty() || !isFixed[chart.firstTriangle]));
  findWithin(islands, isWanted, options, open, found);
}

/// Per vertex of the mesh the least rank of its fans, or the last of all.
IdVector<InputVertex, std::uint32_t> ranksOfMesh(const OpenSurface& open, std::size_t vertices) {
  IdVector<InputVertex, std::uint32_t> out(vertices, std::numeric_limits<std::uint32_t>::max());
  for (const SurfaceVertex v : open.eliminationRanks.ids()) {
    // The surface may meet itself in a vertex; then the numbers of its fans must not matter.
    std::uint32_t& rank = out[open.inputVertex[v]];
    rank = std::min(rank, open.eliminationRanks[v]);
  }
  return out;
}

/// The ranks of a surface for the same mesh opened in another way, since a chart must be solved in
/// the same order whenever it is found.
EliminationRanks ranksOf(const OpenSurface& open, std::size_t vertices, const OpenSurface& other) {
  const IdVector<InputVertex, std::uint32_t> ranks = ranksOfMesh(open, vertices);
  EliminationRanks out;
  for (const InputVertex v : other.inputVertex) out.push_back(ranks[v]);
  return out;
}

OpenSurface openWith(const UncutSurface& uncut, const AskedCuts& asked, const SeamVariant& variant,
                     const UnwrapOptions& options, ThreadPool& pool,
                     const std::function<bool()>& keepsOn, SeamReport& found) {
  OpenSurface open = openAndFill(uncut, asked, options, Pulse(keepsOn));
  open.unit = uncut.unit * unitOf(uncut.welded, open);
  SeamOptions toBegin = seamOptions(options, open, pool, keepsOn, variant.costs);
  // How much stretch refining leaves is only known to about a third, and cutting again takes
  // another run.
  constexpr double kShare = 0.85;
  if (options.balance > 0) toBegin.maxStretch = 1 + kShare * (toBegin.maxStretch - 1);
  if (variant.before)
    toBegin.eliminationRanks = ranksOf(*variant.before, uncut.welded.mesh.vertexCount(), open);
  // Symmetric seams that were not preferable hardly ever become so.
  const bool isAsymmetric = variant.before && !variant.before->mirror;
  if (isAsymmetric && options.symmetricSeams == SymmetricSeams::Auto)
    toBegin.symmetricSeams = SymmetricSeams::Never;
  const EliminationRanks ranks = toBegin.eliminationRanks;
  findAround(uncut.fixed.isFixed, toBegin, open, found);
  if (variant.before) open.eliminationRanks = ranks;
  if (isForFront(variant.costs)) open.variant = variant.costs;
  return open;
}

/// Cuts flat regions with holes out along their creases, if that costs less than seams through
/// them.
void openPlates(const UncutSurface& uncut, const AskedCuts& asked, int costs,
                const UnwrapOptions& options, ThreadPool& pool,
                const std::function<bool()>& keepsOn, OpenSurface& open, SeamReport& found) {
  const Seams borders = plateBorders(open.mesh);
  if (borders.empty()) return;
  AskedCuts along = asked;
  for (const SurfaceCorner h : along.seams.ids()) along.seams[h] = along.seams[h] || borders[h];
  SeamReport report;
  OpenSurface other = openWith(uncut, along, {costs, &open}, options, pool, keepsOn, report);
  if (report.cancelled) found.cancelled = true;
  const SeamOptions how = seamOptions(options, open, pool, keepsOn);
  // Of symmetric seams less is known than of those that they were preferred to.
  const auto costOf = [&](const OpenSurface& x) {
    const bool isSure = x.otherwise.seams.empty();
    return costOfWhole(x.mesh, isSure ? x.seams : x.otherwise.seams,
                       isSure ? x.scale : x.otherwise.scale, how.maxStretch, how.prices);
  };
  // On the surface that is open there, the borders no longer know what they cost.
  double ofBorders = 0;
  for (const SurfaceCorner h : borders.ids())
    if (borders[h] && !other.mesh.twin[h].exists()) ofBorders += open.mesh.cost[h] / 2;
  ofBorders /= std::sqrt(open.mesh.totalArea());
  if (report.cancelled || !(costOf(other) + ofBorders < costOf(open))) return;
  open = std::move(other);
  found = std::move(report);
}

/// The larger value of each chart and its mirror image, so that both are cut alike.
IdVector<CutChartId, double> withImages(const OpenSurface& open, const CutSurface& s,
                                        IdVector<CutChartId, double> excess) {
  IdVector<CutChartId, CutChartId> image(excess.size());
  for (const SurfaceCorner h : open.mirror.image.ids()) {
    const SurfaceCorner there = open.mirror.image[h];
    // The mirror turns the surface around, so what is on the left comes to the right.
    if (there.exists() && s.twin[h].exists())
      image[s.chartOf(h)] = s.chartOf(open.mesh.twin[there]);
  }
  IdVector<CutChartId, double> out = excess;
  for (const CutChartId c : image.ids())
    if (image[c].exists() && image[image[c]] == c)
      out[image[c]] = std::max(out[image[c]], excess[c]);
  return out;
}

/// Whether much of the surface, cut symmetrically, was stretched much more than expected.
bool isWorseThanExpected(const OpenSurface& open, const CutSurface& s,
                         const IdVector<CutChartId, double>& excess) {
  constexpr double kMuchMore = 1.35, kMuch = 0.5;
  double area = 0;
  for (const CutChartId c : s.charts.ids())
    if (excess[c] > kMuchMore) area += s.charts[c].area;
  return !open.otherwise.seams.empty() && area > kMuch * open.mesh.totalArea();
}

/// Goes back to the seams that symmetric ones were preferred to.
void takeOther(OpenSurface& open) {
  open.mirror = Mirror();
  open.seams = std::move(open.otherwise.seams);
  open.found = std::move(open.otherwise.found);
  open.scale = std::move(open.otherwise.scale);
  open.foundScale = std::move(open.otherwise.foundScale);
  open.otherwise = KnownSeams();
}

}  // namespace

std::string asymmetryNote(const OpenSurface& open, const UnwrapOptions& options) {
  if (!options.seams.isAuto || options.symmetricSeams != SymmetricSeams::Always || open.mirror)
    return {};
  const std::string what = "seams are not symmetric: ";
  if (open.asymmetry == Asymmetry::NoPlane) return what + "the mesh is not its own mirror image";
  if (open.asymmetry == Asymmetry::SeamsGiven) return what + "some seams or islands were given";
  return what + "charts would be stretched too much or overlap themselves";
}

std::string scaleNote(const ScaleJump& jump, const SurfaceMap& map, double unit) {
  const auto face = [&](auto triangle) {
    return "face " + std::to_string(std::uint32_t{map.face(triangle)});
  };
  return "faces of very different sizes are cut apart: " + face(jump.large) + " is " +
         withDigits(jump.largeSide * unit, 3) + " long, its neighbour, " + face(jump.small) +
         ", is " + withDigits(jump.smallSide * unit, 3);
}

OpenSurface cutOpen(const UncutSurface& uncut, const AskedCuts& asked, const SeamVariant& variant,
                    const UnwrapOptions& options, ThreadPool& pool,
                    const std::function<bool()>& keepsOn, SeamSummary& summary) {
  SeamReport found;
  OpenSurface open = openWith(uncut, asked, variant, options, pool, keepsOn, found);
  const bool isSymmetric = options.symmetricSeams == SymmetricSeams::Always;
  if (options.seams.isAuto && !isSymmetric && !found.cancelled)
    openPlates(uncut, asked, variant.costs, options, pool, keepsOn, open, found);
  summary.genus = uncut.surface.summary.genus;
  summary.handleLoops = found.handleLoops;
  summary.handleLength = found.handleLength;
  open.asymmetry = found.asymmetry;
  return open;
}

Further cutStretched(const ChartSet& set, const IdVector<ChartId, Stretched>& charts,
                     const UnwrapOptions& options, ThreadPool& pool, std::function<bool()> keepsOn,
                     OpenSurface& open) {
  const auto isAsked = [](const Stretched& chart) { return chart.stretch > 0; };
  if (std::none_of(charts.begin(), charts.end(), isAsked)) return Further::Nothing;
  const CutSurface s = cutAlong(open.mesh, open.seams);
  const Prediction expected = predictStretch(open.mesh, s, open.scale);
  IdVector<CutChartId, double> excess(s.charts.size(), 0);  // 0: leave the chart alone
  bool isAnyRestored = false;
  for (const ChartId i : charts.ids()) {
    if (!isAsked(charts[i])) continue;
    const CutChartId c = s.chartOfTriangle[set.topology(i).triangles.front()];
    if (charts[i].isInvalid && restore(s, c, open)) {
      isAnyRestored = true;
      continue;
    }
    const double told = (expected.stretch[c] - 1) / expected.excess[c];
    if (!(told > 0)) continue;
    // Above kMost the distortion is not due to area alone: add one seam, and let flattening tell.
    constexpr double kMost = 8, kSlightly = 1.01;
    const auto above = [&](double x) {
      return stretchBeforeRefining(x, Energy(options.balance)) - 1;
    };
    const double leastToCut = kSlightly * above(options.maxStretch) / told;
    // Invalid charts have not been refined.
    const double found = charts[i].isInvalid ? std::max((charts[i].stretch - 1) / told, leastToCut)
                                             : above(charts[i].stretch) / told;
    excess[c] = std::min(found, std::max(kMost, leastToCut));
  }
  if (isWorseThanExpected(open, s, excess)) {
    takeOther(open);
    return Further::Replaced;
  }
  open.otherwise = KnownSeams();
  excess = withImages(open, s, std::move(excess));
  open.mesh.excess.resize(open.mesh.triangleCount(), 1);
  for (const SurfaceTriangle f : open.mesh.triangles())
    if (const double x = excess[s.chartOfTriangle[f]]; x > 0) open.mesh.excess[f] = x;
  const CutSurface apart = cutAlong(open.mesh, seamsBetween(s, open));
  IdVector<CutChartId, std::uint8_t> isWanted(apart.charts.size(), 0);
  for (const CutChartId c : s.charts.ids())
    if (excess[c] > 0) isWanted[apart.chartOfTriangle[s.charts[c].firstTriangle]] = 1;
  SeamReport found;
  const bool isAnyFound =
      findWithin(apart, isWanted,
                 seamOptions(options, open, pool, std::move(keepsOn), open.variant), open, found);
  return isAnyFound || isAnyRestored ? Further::Cut : Further::Nothing;
}

bool halve(const ChartSet& set, const IdVector<ChartId, std::uint8_t>& isAsked,
           const UnwrapOptionValues& options, OpenSurface& open,
           IdVector<ChartId, std::uint8_t>& isWhole) {
  isWhole.assign(set.size(), 0);
  if (std::find(isAsked.begin(), isAsked.end(), 1) == isAsked.end()) return false;
  open.seams.resize(open.mesh.twin.size(), 0);
  open.found.resize(open.mesh.twin.size(), 0);
  const CutSurface s = cutAlong(open.mesh, open.seams);
  const auto cutChartOf = [&](ChartId i) {
    return s.chartOfTriangle[set.topology(i).triangles.front()];
  };
  IdVector<CutChartId, std::uint8_t> isWanted(s.charts.size(), 0);
  for (const ChartId i : set.ids()) isWanted[cutChartOf(i)] = isAsked[i];
  const IdVector<CutChartId, std::uint8_t> isHalved =
      halveCharts(open.mesh, s, isWanted, open.seams);
  openTouchedHoles(open.mesh, cutAlong(open.mesh, open.seams), options.fillHoles, open.seams);
  for (const SurfaceCorner h : open.seams.ids()) open.found[h] = open.found[h] || open.seams[h];
  bool isAny = false;
  for (const ChartId i : set.ids()) {
    isWhole[i] = isAsked[i] && !isHalved[cutChartOf(i)];
    isAny = isAny || isHalved[cutChartOf(i)];
  }
  return isAny;
}

void expectScale(const ChartSet& set, const IdVector<ChartId, std::uint8_t>& isAsked,
                 ThreadPool& pool, OpenSurface& open) {
  if (std::find(isAsked.begin(), isAsked.end(), 1) == isAsked.end()) return;
  const CutSurface s = cutAlong(open.mesh, open.seams);
  IdVector<CutChartId, std::uint8_t> isWanted(s.charts.size(), 0);
  for (const ChartId i : set.ids())
    isWanted[s.chartOfTriangle[set.topology(i).triangles.front()]] = isAsked[i];
  const SeamPart part = extractCharts(open.mesh, s, isWanted);
  LogScale scale(part.mesh, &pool, part.ofVertices(open.eliminationRanks));
  const CutSurface whole = cutAlong(part.mesh, Seams(part.mesh.twin.size(), 0));
  const LogScales u = scale.solve(whole, {});
  for (const SurfaceVertex v : u.ids()) open.scale[part.wholeVertex[v]] = u[v];
}

ChartSet chartsOf(const WeldedMesh& welded, const OpenSurface& open) {
  ChartSet out = makeCharts(welded.mesh, filledTable(open.mesh, open.inputVertex, open.seams));
  // Charts are factored in the order found for the whole surface.
  out.eliminationRank = ranksOfMesh(open, welded.mesh.vertexCount());
  return out;
}

Seams visibleSeams(const OpenSurface& open) {
  Seams out = open.given;
  for (const SurfaceCorner h : out.ids())
    out[h] = out[h] || (open.seams[h] && open.mesh.isOnSurface(h));
  return out;
}

void measureSeams(const OpenSurface& open, const Seams& visible, SeamSummary& summary) {
  double length = 0;
  for (const SurfaceCorner h : visible.ids()) {
    if (!visible[h]) continue;
    length += open.mesh.length[h] / 2;
    ++summary.edges;
  }
  summary.edges /= 2;
  const double size = std::sqrt(open.mesh.totalArea());
  summary.relativeLength = size > 0 ? length / size : 0;
}

void measureSeams(const std::vector<double>& positions, const CornerTable& table,
                  const Seams& visible, SeamSummary& summary) {
  LongSum length, area;
  for (const SurfaceTriangle f : table.triangles()) {
    area.add(areaOf(positions, verticesOf(table.vertex, f)));
    for (const SurfaceCorner h : cornersOf(f)) {
      if (!visible[h]) continue;
      length.add(norm(edgeVector(positions, table.vertex[h], table.vertex[nextCorner(h)])) / 2);
      ++summary.edges;
    }
  }
  summary.edges /= 2;
  summary.relativeLength = area.value() > 0 ? length.value() / std::sqrt(area.value()) : 0;
}

double seamCost(const OpenSurface& open) {
  const double size = std::sqrt(open.mesh.totalArea());
  double sum = 0;
  const Seams visible = visibleSeams(open);
  for (const SurfaceCorner h : visible.ids())
    if (visible[h]) sum += open.mesh.cost[h] / 2;
  return size > 0 ? sum / size : 0;
}

double seamLength(const OpenSurface& open) {
  SeamSummary out;
  measureSeams(open, visibleSeams(open), out);
  return out.relativeLength;
}

}  // namespace abflat
