#include "unwrap_seams.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hole/fill_holes.h"
#include "hole/filled_table.h"
#include "seam/extract_charts.h"
#include "seam/find_seams.h"
#include "seam/prediction.h"

namespace abflat {
namespace {

/// The surface opened along what is given, so that the holes of its charts show, and with these
/// filled; where there are none the surface as it is, which has the same elimination order whatever
/// is given. The seams are those that are given but not its boundary.
OpenSurface openAndFill(const WeldedMesh& welded, const Surface& surface, Seams given,
                        const Scales& scales, const FixedTriangles& fixed, FillHoles mode,
                        const Pulse& pulse) {
  CornerTable table = surface.table;
  for (std::size_t h = 0; h < given.size(); ++h)
    if (given[h]) table.twin[h] = kNone;
  const auto meshOf = [&](const CornerTable& t, const Fans& fans) {
    return makeSeamMesh(welded.mesh.positions, t, fans, surface.triangulation.isDiagonal,
                        scales.ofTriangle, pulse);
  };
  const bool isAny = std::find(given.begin(), given.end(), 1) != given.end();
  Fans fans = isAny ? findFans(table, welded.mesh.vertexCount()) : surface.fans;
  OpenSurface out;
  out.mesh = meshOf(table, fans);
  fillHoles(mode, fixed.isFixed, out.mesh, pulse);
  if (isAny && out.mesh.hole.empty() && fixed.isFixed.empty() && scales.ofTriangle.empty()) {
    fans = surface.fans;
    out.mesh = meshOf(surface.table, fans);
    out.seams = given;
  }
  out.inputVertex = std::move(fans.inputVertex);
  out.given = std::move(given);
  return out;
}

/// The stretch of a conformal layout that refining turns into the given one, about: of what is
/// above 1 a share is left that depends on the balance, and little on the chart.
double beforeRefining(double stretch, double balance) {
  const double left = balance > 0 ? 0.2 + 0.8 / (1 + 40 * balance) : 1;
  return 1 + (stretch - 1) / left;
}

SeamOptions seamOptions(const UnwrapOptions& options, ThreadPool& pool,
                        std::function<bool()> keepsOn) {
  SeamOptions out;
  out.isAuto = options.seams.isAuto;
  out.maxStretch = beforeRefining(options.maxStretch, options.balance);
  out.fillHoles = options.fillHoles;
  out.pool = &pool;
  out.keepsOn = std::move(keepsOn);
  return out;
}

/// Adds seams within the charts that are wanted alone to those of `open`; false when there are
/// none.
bool findWithin(const CutSurface& surface, const std::vector<std::uint8_t>& isWanted,
                SeamOptions options, OpenSurface& open, SeamReport& found) {
  const SeamPart part = extractCharts(open.mesh, surface, isWanted);
  const bool hasPlace = !open.place.empty();
  if (hasPlace)
    for (const std::uint32_t v : part.vertex) options.place.push_back(open.place[v]);
  open.seams.resize(open.mesh.twin.size(), 0);
  Seams given;
  for (const std::uint32_t h : part.halfEdge) given.push_back(open.seams[h]);
  const Seams seams = findSeams(part.mesh, std::move(given), options, &found);
  bool isAny = false;
  for (std::size_t h = 0; h < seams.size(); ++h) {
    if (!seams[h]) continue;
    open.seams[part.halfEdge[h]] = 1;
    isAny = true;
  }
  open.place.resize(open.mesh.vertexCount(), 0);
  open.scale.resize(open.mesh.vertexCount(), 0);
  for (std::size_t v = 0; v < found.place.size(); ++v) {
    // A chart is to be solved in the same order whenever it is found.
    if (!hasPlace) open.place[part.vertex[v]] = found.place[v];
    open.scale[part.vertex[v]] = found.scale[v];
  }
  return isAny;
}

bool isAlone(const SeamMesh& mesh, std::uint32_t triangle) {
  const std::uint32_t* twin = &mesh.twin[3 * std::size_t{triangle}];
  return twin[0] == kNone && twin[1] == kNone && twin[2] == kNone;
}

bool areMostAlone(const SeamMesh& mesh) {
  std::uint32_t alone = 0;
  for (std::uint32_t f = 0; f < mesh.triangleCount(); ++f) alone += isAlone(mesh, f);
  return alone > mesh.triangleCount() / 2;
}

/// Fixed islands are left out: they are not to be cut, and may have holes. Their borders are open.
/// So are triangles alone, where they are many: there is nothing to search.
void findAround(const std::vector<std::uint8_t>& isFixed, const SeamOptions& options,
                OpenSurface& open, SeamReport& found) {
  if (isFixed.empty() && !areMostAlone(open.mesh)) {
    open.seams = findSeams(open.mesh, std::move(open.seams), options, &found);
    open.place = std::move(found.place);
    open.scale = std::move(found.scale);
    return;
  }
  const CutSurface islands = cutAlong(open.mesh, Seams(open.mesh.twin.size(), 0));
  std::vector<std::uint8_t> isWanted;
  for (const CutSurface::Chart& chart : islands.charts)
    isWanted.push_back(chart.triangles > 1 && (isFixed.empty() || !isFixed[chart.firstTriangle]));
  findWithin(islands, isWanted, options, open, found);
}

/// What is given, without what lies within fixed islands, and the borders of these.
Seams withBorders(const Seams& given, const FixedTriangles& fixed) {
  if (fixed.isFixed.empty()) return given;
  Seams out = fixed.borders;
  for (std::size_t h = 0; h < out.size(); ++h)
    if (given[h] && !fixed.isFixed[h / 3]) out[h] = 1;
  return out;
}

}  // namespace

OpenSurface cutOpen(const WeldedMesh& welded, const Surface& surface, const Seams& asked,
                    const Scales& scales, const FixedTriangles& fixed, const UnwrapOptions& options,
                    ThreadPool& pool, std::function<bool()> keepsOn, SeamSummary& summary) {
  OpenSurface open = openAndFill(welded, surface, withBorders(asked, fixed), scales, fixed,
                                 options.fillHoles, Pulse(keepsOn));
  SeamReport found;
  findAround(fixed.isFixed, seamOptions(options, pool, std::move(keepsOn)), open, found);
  summary.genus = surface.summary.genus;
  summary.handleLoops = found.handleLoops;
  summary.handleLength = found.handleLength;
  return open;
}

bool cutStretched(const ChartSet& set, const std::vector<double>& stretch,
                  const UnwrapOptions& options, ThreadPool& pool, std::function<bool()> keepsOn,
                  OpenSurface& open) {
  const auto isAbove = [&](double x) { return x > options.maxStretch; };
  if (std::none_of(stretch.begin(), stretch.end(), isAbove)) return false;
  const CutSurface s = cutAlong(open.mesh, open.seams);
  const Prediction expected = predictStretch(open.mesh, s, open.scale);
  std::vector<std::uint8_t> isWanted(s.charts.size(), 0);
  std::vector<double> excess(s.charts.size(), 0);
  for (std::size_t i = 0; i < stretch.size(); ++i) {
    if (!isAbove(stretch[i])) continue;
    const std::uint32_t c = s.chartOfTriangle[set.triangles(i).front()];
    const double told = (expected.stretch[c] - 1) / expected.excess[c];
    if (!(told > 0)) continue;
    isWanted[c] = 1;
    // Where it is more, it is not area alone that is distorted: one seam, and flattening tells.
    constexpr double kMost = 8, kSlightly = 1.01;
    const auto above = [&](double x) { return beforeRefining(x, options.balance) - 1; };
    const double leastToCut = kSlightly * above(options.maxStretch) / told;
    excess[c] = std::min(above(stretch[i]) / told, std::max(kMost, leastToCut));
  }
  open.mesh.excess.resize(open.mesh.triangleCount(), 1);
  for (std::uint32_t f = 0; f < open.mesh.triangleCount(); ++f)
    if (const std::uint32_t c = s.chartOfTriangle[f]; isWanted[c]) open.mesh.excess[f] = excess[c];
  SeamReport found;
  return findWithin(s, isWanted, seamOptions(options, pool, std::move(keepsOn)), open, found);
}

ChartSet chartsOf(const WeldedMesh& welded, const OpenSurface& open) {
  ChartSet out = makeCharts(welded.mesh, filledTable(open.mesh, open.inputVertex, open.seams));
  // Charts are factored in the order that was found for the whole surface.
  out.place.assign(welded.mesh.vertexCount(), 0);
  for (std::size_t i = 0; i < open.place.size(); ++i)
    out.place[open.inputVertex[i]] = open.place[i];
  return out;
}

Seams visibleSeams(const OpenSurface& open) {
  Seams out = open.given;
  for (std::uint32_t h = 0; h < out.size(); ++h)
    out[h] = out[h] || (open.seams[h] && open.mesh.isOnSurface(h));
  return out;
}

void measureSeams(const OpenSurface& open, const Seams& visible, SeamSummary& summary) {
  double length = 0;
  for (std::size_t h = 0; h < visible.size(); ++h) {
    if (!visible[h]) continue;
    length += open.mesh.length[h] / 2;
    ++summary.edges;
  }
  summary.edges /= 2;
  const double size = std::sqrt(open.mesh.totalArea());
  summary.relativeLength = size > 0 ? length / size : 0;
}

}  // namespace abflat
