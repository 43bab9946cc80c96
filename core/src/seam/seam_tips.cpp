#include "seam/seam_tips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/constants.h"
#include "base/portable_math.h"

namespace abflat {
namespace {

/// The most that one round may free; beyond that the first-order estimate is useless.
constexpr double kMostScale = 0.35;

/// The derivative of a chart's stretch by the scale of each of its vertices.
IdVector<SurfaceVertex, double> gradientOf(const TipSearch& t, const CutSurface& s,
                                           const Prediction& p) {
  IdVector<CutChartId, double> shrunk(s.charts.size(), 0);  // mean of e^(-2u) times the area
  for (const CutChartId c : s.charts.ids()) shrunk[c] = s.charts[c].area;
  for (const OpenVertex v : s.vertices()) {
    const SurfaceVertex i = s.meshVertex[v];
    if (!s.isBoundary[v])
      shrunk[s.chartOf(v)] += t.mesh.vertexArea[i] * (portable::exp(-2 * t.u[i]) - 1);
  }
  IdVector<SurfaceVertex, double> out(t.mesh.vertexCount(), 0);
  for (const OpenVertex v : s.vertices()) {
    const SurfaceVertex i = s.meshVertex[v];
    const CutChartId c = s.chartOf(v);
    const double area = s.charts[c].area, grown = portable::exp(2 * t.u[i]);
    if (area > 0)
      out[i] = p.excess[c] * t.mesh.vertexArea[i] / area *
               (grown * shrunk[c] / area - p.meanScale[c] / grown);
  }
  return out;
}

/// The residual b - A x of the system. At a vertex held at zero it is the force that holds it
/// there.
IdVector<SurfaceVertex, double> lackOf(const SeamMesh& mesh, IdVector<SurfaceVertex, double> b,
                                       const IdVector<SurfaceVertex, double>& x) {
  for (const SurfaceCorner h : mesh.corners()) {
    if (mesh.twin[h] < h) continue;
    const SurfaceVertex i = mesh.tail(h), j = mesh.head(h);
    const double flow = mesh.stiffness(h) * (x[i] - x[j]);
    b[i] -= flow;
    b[j] += flow;
  }
  return b;
}

/// The seams at a vertex as outgoing half-edges, up to three. A vertex on the mesh's boundary
/// counts as having three.
struct SeamsAt {
  std::array<SurfaceCorner, 3> h;
  int count = 0;
};

SeamsAt seamsAt(const TipSearch& t, SurfaceVertex v) {
  SeamsAt out;
  const SurfaceCorner first = t.outgoing[v];
  if (!rotateClockwise(t.mesh.twin, first).exists()) {
    out.count = 3;
    return out;
  }
  SurfaceCorner h = first;
  do {
    if (t.seams[h]) out.h[static_cast<std::size_t>(out.count++)] = h;
    h = rotateCounterClockwise(t.mesh.twin, h);
  } while (h.exists() && h != first && out.count < 3);
  return out;
}

bool isFree(const TipSearch& t, SurfaceCorner h) { return !t.kept[h] && t.mesh.isOnSurface(h); }

/// The path from an end. If both of its ends are free, only half of it.
std::vector<SurfaceCorner> pathFrom(const TipSearch& t, SurfaceVertex end) {
  std::vector<SurfaceCorner> out;
  SeamsAt at = seamsAt(t, end);
  if (at.count != 1) return out;
  SurfaceCorner h = at.h[0];
  while (isFree(t, h)) {
    out.push_back(h);
    at = seamsAt(t, t.mesh.head(h));
    if (at.count != 2) break;
    h = at.h[0] == t.mesh.twin[h] ? at.h[1] : at.h[0];
  }
  if (at.count == 1) out.resize(out.size() / 2);
  return out;
}

/// Several neighbouring vertices of a path, lumped together.
struct Lump {
  double distance = 0;  ///< from where the shortened path would end
  double size = 0, flux = 0, adjoint = 0;
};

/// Green's function of the plane slit along a ray, for points on the continuation of the ray.
double influence(const Lump& x, const Lump& y) {
  constexpr double kOwn = 0.15;  // distance of a lump from itself, relative to its size
  const double a = std::sqrt(x.distance), b = std::sqrt(y.distance);
  const double apart = std::max(std::abs(a - b), kOwn * (x.size + y.size) / (a + b));
  return portable::log((a + b) / apart) / (2 * kPi);
}

std::vector<Lump> lumpsOf(const SeamTip& tip, const std::vector<double>& flux,
                          const std::vector<double>& adjoint, std::size_t count) {
  constexpr std::size_t kMost = 24;
  std::vector<Lump> out(std::min(count, kMost));
  std::vector<std::size_t> in(out.size(), 0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = i * out.size() / count;
    const double passed = i == 0 ? 0 : tip.length[i - 1];
    out[k].distance += tip.length[count - 1] - passed;
    out[k].size += tip.length[i] - passed;
    out[k].flux += flux[i];
    out[k].adjoint += adjoint[i];
    ++in[k];
  }
  for (std::size_t k = 0; k < out.size(); ++k) out[k].distance /= static_cast<double>(in[k]);
  return out;
}

/// The stretch that the chart gains without the first `count` edges.
double stretchWithout(const SeamTip& tip, const std::vector<double>& flux,
                      const std::vector<double>& adjoint, std::size_t count) {
  const std::vector<Lump> lumps = lumpsOf(tip, flux, adjoint, count);
  double sum = 0, most = 0;
  for (const Lump& x : lumps) {
    double freed = 0;
    for (const Lump& y : lumps) freed += influence(x, y) * y.flux;
    sum += x.adjoint * freed;
    most = std::max(most, std::abs(freed));
  }
  if (count > 1 && most > kMostScale) return std::numeric_limits<double>::infinity();
  return std::max(0.0, sum);
}

/// Computed for ever more widely spaced numbers of edges; the numbers in between use the value of
/// the next one. Removing more is never cheaper.
void setStretch(const std::vector<double>& flux, const std::vector<double>& adjoint, SeamTip& tip) {
  const std::size_t n = tip.edges.size();
  tip.stretch.assign(n, 0);
  std::size_t from = 0;
  double least = 0;
  for (std::size_t count = 1; from < n; count = std::min(n, count + 1 + count / 4)) {
    least = std::max(least, stretchWithout(tip, flux, adjoint, count));
    for (; from < count; ++from) tip.stretch[from] = least;
  }
}

}  // namespace

IdVector<SurfaceVertex, SurfaceCorner> outgoingHalfEdges(const SeamMesh& mesh) {
  IdVector<SurfaceVertex, SurfaceCorner> out(mesh.vertexCount());
  for (const SurfaceCorner h : mesh.corners()) {
    SurfaceCorner& first = out[mesh.tail(h)];
    if (!first.exists() || !rotateClockwise(mesh.twin, h).exists()) first = h;
  }
  return out;
}

std::vector<SeamTip> findTips(const TipSearch& t, const CutSurface& s, const Prediction& p,
                              const IdVector<CutChartId, std::uint8_t>& isWanted, LogScale& scale) {
  const SeamMesh& mesh = t.mesh;
  IdVector<SurfaceVertex, double> curvature, adjoint = gradientOf(t, s, p);
  for (const SurfaceVertex i : mesh.vertices()) curvature.push_back(mesh.angleSum[i] - 2 * kPi);
  const IdVector<SurfaceVertex, double> lack = lackOf(mesh, std::move(curvature), t.u);
  IdVector<SurfaceVertex, double> gradient = adjoint;
  for (const OpenVertex v : s.vertices())
    if (s.isBoundary[v]) adjoint[s.meshVertex[v]] = 0;
  scale.solveAgain(adjoint);
  const IdVector<SurfaceVertex, double> lackOfAdjoint = lackOf(mesh, std::move(gradient), adjoint);
  std::vector<SeamTip> out;
  for (const SurfaceVertex v : mesh.vertices()) {
    SeamTip tip;
    tip.edges = pathFrom(t, v);
    if (tip.edges.empty()) continue;
    tip.chart = s.chartOf(tip.edges.front());
    if (!isWanted[tip.chart]) continue;
    std::vector<double> flux, fluxOfAdjoint;
    double length = 0;
    for (const SurfaceCorner h : tip.edges) {
      length += mesh.cost[h];
      tip.length.push_back(length);
      flux.push_back(lack[mesh.vertexOfCorner[h]]);
      fluxOfAdjoint.push_back(lackOfAdjoint[mesh.vertexOfCorner[h]]);
    }
    setStretch(flux, fluxOfAdjoint, tip);
    out.push_back(std::move(tip));
  }
  return out;
}

}  // namespace abflat
