// Automatic seams of meshes, and what flattening makes of the charts, as one line each.
//
//   abflat_seam_bench make KIND N FILE.obj       rings0..rings6, noiseF (F bumps), on a grid of N^3
//   abflat_seam_bench subdivide IN FILE.obj      one to four
//   abflat_seam_bench run [--flatten] [--t T] [--stretch S] [--fill A] [--overlap O] FILE...
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <map>
#include <string>

#include "abflat/flatten.h"
#include "abflat/io.h"
#include "base/stopwatch.h"
#include "bench_matrices.h"
#include "mesh/surface.h"
#include "seam/find_seams.h"
#include "support/isosurface.h"

using namespace abflat;

namespace {

bool read(const std::string& path, PolygonMesh& mesh) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const Result<MeshFormat> format = detectFormat(path, bytes);
  Result<PolygonMesh> result =
      format.ok() ? readMesh(bytes, format.value(), path) : format.status();
  if (!result.ok()) std::fprintf(stderr, "%s\n", result.status().message.c_str());
  mesh = std::move(result.value());
  return result.ok();
}

bool write(const std::string& path, const PolygonMesh& mesh) {
  std::ofstream out(path);
  char line[128];
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    const double* p = &mesh.positions[3 * v];
    std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", p[0], p[1], p[2]);
    out << line;
  }
  for (std::size_t c = 0; c < mesh.faceVertices.size(); c += 3)
    out << "f " << mesh.faceVertices[c] + 1 << ' ' << mesh.faceVertices[c + 1] + 1 << ' '
        << mesh.faceVertices[c + 2] + 1 << '\n';
  return static_cast<bool>(out);
}

PolygonMesh chartMesh(const PolygonMesh& mesh, const Surface& surface, const CutSurface& s,
                      CutChartId chart) {
  std::vector<double> positions;
  std::vector<std::uint32_t> indices;
  std::map<OpenVertex, std::uint32_t> id;
  for (const SurfaceTriangle f : s.trianglesOf(chart))
    for (const SurfaceCorner c : cornersOf(f)) {
      const auto [at, isNew] =
          id.emplace(s.vertexOfCorner[c], static_cast<std::uint32_t>(id.size()));
      if (isNew)
        for (std::size_t d = 0; d < 3; ++d)
          positions.push_back(mesh.positions[3 * surface.table.vertex[c] + d]);
      indices.push_back(at->second);
    }
  return makeTriangleMesh(std::move(positions), std::move(indices));
}

/// Sums over all charts; the stretch is the mean by area at one scale for each chart's area.
struct Flattened {
  double stretch = 0, area = 0, seconds = 0;
  std::size_t invalid = 0, failed = 0, fallbacks = 0, notDisks = 0, crossings = 0, untangled = 0;
};

Flattened flattenCharts(const PolygonMesh& mesh, const Surface& surface, const CutSurface& s,
                        double t) {
  Flattened out;
  Stopwatch watch;
  for (const CutChartId c : s.charts.ids()) {
    if (!s.charts[c].isDisk()) ++out.notDisks;
    FlattenOptions options;
    options.t = t;
    options.threads = 1;
    const Result<FlattenResult> flat = flatten(chartMesh(mesh, surface, s, c), options);
    if (!flat.ok()) {
      if (out.failed++ < 3) std::fprintf(stderr, "  %s\n", flat.status().message.c_str());
      continue;
    }
    const ChartReport& report = flat.value().report.charts.front();
    out.invalid += !report.valid;
    out.crossings += report.boundaryCrossings;
    out.untangled += !report.bounds.empty() || report.t < 2;
    out.fallbacks += !report.fallbacks.empty();
    if (std::isfinite(report.symmetricDirichlet)) {
      out.stretch += s.charts[c].area * report.symmetricDirichlet;
      out.area += s.charts[c].area;
    }
  }
  out.stretch /= out.area;
  out.seconds = watch.lap();
  return out;
}

int run(int argc, char** argv) {
  SeamOptions options;
  bool flattens = false;
  double t = 2;
  for (int i = 0; i < argc; ++i) {
    const std::string a = argv[i];
    if (a == "--flatten") {
      flattens = true;
    } else if (a == "--stretch") {
      options.maxStretch = std::atof(argv[++i]);
    } else if (a == "--fill") {
      options.leastFill = std::atof(argv[++i]);
    } else if (a == "--overlap") {
      options.mostOverlap = std::atof(argv[++i]);
    } else if (a == "--t") {
      t = std::strcmp(argv[++i], "auto") == 0 ? kAutoT : std::atof(argv[i]);
    } else {
      PolygonMesh mesh;
      if (!read(a, mesh)) return 1;
      const Surface surface = buildSurface(mesh);
      const std::clock_t begin = std::clock();
      Stopwatch watch;
      const SeamMesh seamMesh = makeSeamMesh(mesh.positions, surface.table, surface.fans);
      const double prepared = watch.lap();
      SeamReport r;
      const Seams seams = findSeams(seamMesh, {}, options, &r);
      const double cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      const CutSurface s = cutAlong(seamMesh, seams);
      std::printf(
          "%-24s F %7u charts %5u seam %7.2f (topology %6.2f) predicted %.4f slits %5u splits %5u "
          "merges %4u rounds %2d  s %.3f cpu %.3f (mesh %.3f analysis %.3f solve %.3f merge %.3f)",
          a.substr(a.rfind('/') + 1).c_str(), seamMesh.triangleCount(), r.charts, r.seamLength,
          r.handleLength, r.stretch, r.slits, r.splits, r.merges, r.rounds, prepared + r.seconds,
          cpu, prepared, r.analysisSeconds, r.solveSeconds, r.mergeSeconds);
      if (flattens) {
        const Flattened f = flattenCharts(mesh, surface, s, t);
        std::printf(
            "  SD/4 %.4f invalid %zu failed %zu hard %zu notDisks %zu crossings %zu untangled %zu "
            "flatten %.2f s",
            f.stretch, f.invalid, f.failed, f.fallbacks, f.notDisks, f.crossings, f.untangled,
            f.seconds);
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
  return 0;
}

int make(const std::string& kind, unsigned cells, const std::string& path) {
  const test::Field field = kind.compare(0, 5, "rings") == 0
                                ? test::rings(static_cast<unsigned>(std::atoi(&kind[5])))
                                : test::noise(std::atof(&kind[5]), 1);
  return write(path, test::isosurface(cells, field)) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "make" && argc == 5)
    return make(argv[2], static_cast<unsigned>(std::atoi(argv[3])), argv[4]);
  if (what == "subdivide" && argc == 4) {
    PolygonMesh mesh;
    return read(argv[2], mesh) && write(argv[3], bench::subdivided(mesh)) ? 0 : 1;
  }
  if (what == "run") return run(argc - 2, argv + 2);
  std::fprintf(stderr, "usage: see the top of seam_bench.cpp\n");
  return 2;
}
