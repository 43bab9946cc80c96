#include "abflat/compare.h"

#include <utility>

#include "abflat/mesh.h"
#include "base/counted.h"
#include "base/guarded.h"
#include "base/stopwatch.h"
#include "chart/disk_chart.h"
#include "check/distortion.h"
#include "check/validity.h"
#include "layout/pose.h"
#include "layout/tutte.h"
#include "mesh/surface.h"
#include "reference/edge_weights.h"
#include "reference/lscm.h"

namespace abflat {
namespace {

Embedding embedMeanValue(const DiskChart& chart) {
  return embedByWeights(chart, meanValueWeights(chart), boundaryOnCircle(chart));
}
Embedding embedHarmonic(const DiskChart& chart) {
  return embedByWeights(chart, harmonicWeights(chart), boundaryOnCircle(chart));
}

struct Method {
  MethodKey key;
  const char* title;
  double work;                           ///< rough share of the total time
  double t, balance;                     ///< of abflat
  Embedding (*embed)(const DiskChart&);  ///< null: abflat
};

/// Leaves MIPS almost unchanged: the other term affects nothing that is measured, and gives the
/// layout a scale.
constexpr double kMips = 1e-6;

constexpr Method kMethods[] = {
    {MethodKey::AbflatAuto, "abflat, t = auto", 4, kAutoT, 0, nullptr},
    {MethodKey::AbflatConvex, "abflat, t = 1 (convex)", 2, 1, 0, nullptr},
    {MethodKey::AbflatFree, "abflat, t = 2 (free)", 2, 2, 0, nullptr},
    {MethodKey::AbflatBalanced, "abflat, balance 0.5", 4, kAutoT, 0.5, nullptr},
    {MethodKey::SymmetricDirichlet, "symmetric Dirichlet, free", 4, kAutoT, 1, nullptr},
    {MethodKey::Mips, "MIPS, free", 4, kAutoT, kMips, nullptr},
    {MethodKey::Tutte, "Tutte, circle", 1, 0, 0, embedTutte},
    {MethodKey::MeanValue, "mean value, circle", 1, 0, 0, embedMeanValue},
    {MethodKey::Harmonic, "harmonic, circle", 1, 0, 0, embedHarmonic},
    {MethodKey::Lscm, "LSCM, free", 1, 0, 0, embedLscm},
};

/// Fills in everything that follows from the coordinates.
void measure(const DiskChart& chart, MethodResult& row) {
  std::vector<double> uv = row.uv;
  for (double& x : uv) x /= chart.unit;  // exact, and away from the ends of the range
  const Validity v = checkValidity(chart, uv);
  row.flippedTriangles = v.flippedTriangles;
  row.boundaryCrossings = v.crossings.count;
  if (row.problem.empty() && v.flippedTriangles > 0)
    row.problem =
        counted(v.flippedTriangles, "triangle is", "triangles are") + " flipped or degenerate";
  else if (row.problem.empty() && v.crossings.count > 0)
    row.problem = "the boundary crosses itself at " + counted(v.crossings.count, "place", "places");
  row.valid = row.problem.empty();
  const Distortion d = measureDistortion(chart, uv);
  row.angularDistortion = d.angular;
  row.lengthDistortion = d.length;
  row.areaDistortion = d.areaLog;
  row.areaRatioMin = d.areaMin;
  row.areaRatioMax = d.areaMax;
  row.quasiConformalMean = d.quasiConformalMean;
  row.quasiConformalMax = d.quasiConformalMax;
  row.quasiConformalSheared = d.sheared;
  row.symmetricDirichlet = d.symmetricDirichlet;
}

class Comparer {
 public:
  Comparer(const PolygonMesh& mesh, const DiskChart& chart, const CompareOptions& options)
      : mesh_(mesh), chart_(chart), options_(options) {}

  /// Errors: Aborted, OutOfMemory.
  Result<std::vector<MethodResult>> run() {
    for (const Method& method : kMethods) total_ += method.work;
    std::vector<MethodResult> rows;
    for (const Method& method : kMethods) {
      if (!tell(method, {Stage::Solve})) return aborted();
      MethodResult row;
      row.method = method.key;
      row.title = method.title;
      const StatusCode code =
          method.embed ? addReference(method, rows.front().uv, row) : addAbflat(method, row);
      if (code == StatusCode::Aborted) return aborted();
      if (code == StatusCode::OutOfMemory) return Status{code, row.problem};
      rows.push_back(std::move(row));
      done_ += method.work;
    }
    return rows;
  }

 private:
  static Status aborted() { return {StatusCode::Aborted, "cancelled"}; }

  /// `inside`: progress within the method.
  bool tell(const Method& method, Progress inside) const {
    inside.method = method.key;
    inside.fraction = (done_ + method.work * inside.fraction) / total_;
    return !options_.progress || options_.progress(inside);
  }

  StatusCode addAbflat(const Method& method, MethodResult& row) const {
    FlattenOptions options;
    options.threads = 1;  // like the methods it is compared with
    options.t = method.t;
    options.balance = method.balance;
    options.progress = [&](const Progress& inside) { return tell(method, inside); };
    Result<FlattenResult> flat = flatten(mesh_, options);
    if (!flat.ok()) {
      row.problem = flat.status().message;
      return flat.status().code;
    }
    const Timings& spent = flat.value().report.timings;
    row.seconds = spent.solve + spent.layout + spent.refine + spent.check;
    row.problem = flat.value().report.charts.front().problem;
    row.uv = std::move(flat.value().uv);
    measure(chart_, row);
    return StatusCode::Ok;
  }

  StatusCode addReference(const Method& method, const std::vector<double>& model,
                          MethodResult& row) const {
    Stopwatch watch;
    Embedding embedding = method.embed(chart_);
    row.problem = std::move(embedding.problem);
    if (row.problem.empty()) {
      row.uv = std::move(embedding.uv);
      pose(chart_, model, row.uv);
      for (double& x : row.uv) x *= chart_.unit;
      measure(chart_, row);
    }
    row.seconds = watch.lap();
    return StatusCode::Ok;
  }

  const PolygonMesh& mesh_;
  const DiskChart& chart_;
  const CompareOptions& options_;
  double total_ = 0, done_ = 0;
};

Result<Comparison> compareMethods(const PolygonMesh& mesh, const CompareOptions& options) {
  if (Status s = validateArrays(mesh); !s.ok()) return s;
  const Surface surface = buildSurface(mesh);
  if (!surface.summary.disk.ok()) return surface.summary.disk;
  const DiskChart chart = makeDiskChart(mesh, surface);
  Result<std::vector<MethodResult>> rows = Comparer(mesh, chart, options).run();
  if (!rows.ok()) return rows.status();
  Comparison out;
  out.input = surface.summary;
  out.methods = std::move(rows.value());
  out.vertexMap.assign(chart.inputVertex.begin(), chart.inputVertex.end());
  out.triangles.assign(chart.vertexOfCorner.begin(), chart.vertexOfCorner.end());
  return out;
}

}  // namespace

Result<Comparison> compare(const PolygonMesh& mesh, const CompareOptions& options) {
  return guarded([&] { return compareMethods(mesh, options); });
}

}  // namespace abflat
