// One mesh from file to file, and the yardsticks on the same mesh, as one line of JSON. npm run
// bench runs it once per size, so that the peak of memory is that size's own.
//
//   abflat_flatten_bench make FACES FILE.obj         the generated head
//   abflat_flatten_bench subdivide IN N FILE.obj     N times one to four
//   abflat_flatten_bench run FILE.obj T REPEAT       medians of REPEAT runs on one thread, each
//                                                    followed by one on two, and the yardsticks
//   abflat_flatten_bench plain FILE.obj T REPEAT     the runs on one thread alone
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "abflat/flatten.h"
#include "abflat/io.h"
#include "abflat/peak_memory.h"
#include "base/stopwatch.h"
#include "bench_matrices.h"
#include "factor_rows.h"

using namespace abflat;

namespace {

/// Relative, in the norm of the right-hand side: far above rounding, far below a wrong answer.
constexpr double kYardstickResidual = 1e-8;

/// The recorded rows count in MB of 10^6 bytes.
constexpr double kMegabytes = 1.048576;

bool readObj(const std::string& path, std::string& bytes, PolygonMesh& mesh) {
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  if (in) {
    bytes.resize(static_cast<std::size_t>(in.tellg()));
    in.seekg(0).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  Result<PolygonMesh> read =
      in ? readMesh(bytes, MeshFormat::Obj, path)
         : Status{StatusCode::UnreadableFile, path + " cannot be opened; check its name"};
  if (!read.ok()) std::fprintf(stderr, "%s\n", read.status().message.c_str());
  mesh = std::move(read.value());
  return read.ok();
}

bool writeText(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) std::fprintf(stderr, "%s cannot be written\n", path.c_str());
  return static_cast<bool>(out);
}

/// One run as the command line program does it; false when there is no layout. `text` gets what it
/// would write.
bool runOnce(const std::string& path, double t, int threads, Report& report, PolygonMesh& mesh,
             std::string& text) {
  Stopwatch watch;
  std::string bytes;
  if (!readObj(path, bytes, mesh)) return false;
  const double read = watch.lap();
  FlattenOptions options;
  options.t = t;
  options.threads = threads;
  Result<FlattenResult> flat = flatten(mesh, options);
  if (!flat.ok()) {
    std::fprintf(stderr, "%s: %s\n", path.c_str(), flat.status().message.c_str());
    return false;
  }
  report = std::move(flat.value().report);
  report.timings.read = read;
  watch.lap();
  const std::string target = path + ".layout";
  text = writeObj(mesh, flat.value().uv, flat.value().cornerUv, bytes);
  const bool written = writeText(target, text);
  report.timings.write = watch.lap();
  std::remove(target.c_str());
  return written;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double medianOf(const std::vector<Report>& runs, double Timings::*stage) {
  std::vector<double> values;
  for (const Report& run : runs) values.push_back(run.timings.*stage);
  return median(std::move(values));
}

/// False when one of them did not solve its system.
bool printYardsticks(const PolygonMesh& mesh, int repeat) {
  const bench::SparseMatrix laplacian = bench::cotangentLaplacian(mesh);
  std::srand(1);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(laplacian.rows());
  bool isSolved = true;
  const auto print = [&](const char* name, const bench::FactorRow& row) {
    if (!(row.residual < kYardstickResidual)) isSolved = false;
    std::printf(", \"%s\": %.6g, \"%sNumeric\": %.6g, \"%sOrdered\": %.6g", name, row.all(), name,
                row.numeric, name, row.numeric + row.solve);
  };
#ifdef ABFLAT_BENCH_CHOLMOD
  print("u", bench::runCholmod(laplacian, b, repeat));
#endif
  print("e", bench::runEigenLlt(laplacian, b, repeat));
  print("own", bench::runOwn(laplacian, b, repeat));
  if (!isSolved) std::fputs("a yardstick did not solve its system\n", stderr);
  return isSolved;
}

bool run(const std::string& path, double t, int repeat, bool isPlain) {
  std::vector<Report> runs(static_cast<std::size_t>(std::max(1, repeat))), runsOnTwo;
  PolygonMesh mesh;
  double memory = 0;
  bool isIdentical = true;
  for (Report& report : runs) {
    std::string text, textOfTwo;
    if (!runOnce(path, t, 1, report, mesh, text)) return false;
    if (memory == 0) memory = kMegabytes * peakMemory();
    if (isPlain) continue;
    runsOnTwo.emplace_back();
    if (!runOnce(path, t, 2, runsOnTwo.back(), mesh, textOfTwo)) return false;
    isIdentical &= text == textOfTwo;
  }
  const ChartReport& chart = runs.back().charts.front();
  double linear = 0;
  for (const NewtonStep& step : chart.history) linear += step.linearSeconds;
  std::printf("{\"faces\": %zu, \"vertices\": %zu, \"t\": %g, \"repeat\": %zu", chart.faces,
              runs.back().input.vertices, chart.t, runs.size());
  const std::pair<const char*, double Timings::*> stages[] = {
      {"read", &Timings::read},   {"connectivity", &Timings::connectivity},
      {"solve", &Timings::solve}, {"layout", &Timings::layout},
      {"check", &Timings::check}, {"write", &Timings::write}};
  for (const auto& [name, stage] : stages)
    std::printf(", \"%s\": %.6g", name, medianOf(runs, stage));
  std::printf(", \"linear\": %.6g, \"iterations\": %d, \"residual\": %.3g", linear,
              chart.iterations, chart.constraintResidual);
  std::printf(", \"fallbacks\": %zu, \"valid\": %s", chart.fallbacks.size(),
              runs.back().valid && chart.converged ? "true" : "false");
  if (std::isfinite(memory)) std::printf(", \"memoryMB\": %.1f", memory);
  if (!isPlain && runsOnTwo.back().threads == 2)
    std::printf(", \"solveOnTwo\": %.6g, \"identical\": %s", medianOf(runsOnTwo, &Timings::solve),
                isIdentical ? "true" : "false");
  const bool isSolved = isPlain || printYardsticks(mesh, repeat);
  std::printf(", \"compiler\": \"%s\"}\n", ABFLAT_COMPILER);
  return isSolved;
}

bool subdivideFile(const std::string& from, int times, const std::string& to) {
  std::string bytes;
  PolygonMesh mesh;
  if (!readObj(from, bytes, mesh)) return false;
  for (int i = 0; i < times; ++i) mesh = bench::subdivided(mesh);
  return writeText(to, writeObj(mesh, {}, {}));
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> args(argv + 1, argv + argc);
  const std::string what = args.empty() ? "" : args[0];
  if (what == "make" && args.size() == 3) {
    const PolygonMesh mesh =
        bench::noisyHead(static_cast<unsigned>(std::strtoul(args[1].c_str(), nullptr, 10)));
    return writeText(args[2], writeObj(mesh, {}, {})) ? 0 : 1;
  }
  if (what == "subdivide" && args.size() == 4)
    return subdivideFile(args[1], std::atoi(args[2].c_str()), args[3]) ? 0 : 1;
  if ((what == "run" || what == "plain") && args.size() == 4)
    return run(args[1], std::atof(args[2].c_str()), std::atoi(args[3].c_str()), what == "plain")
               ? 0
               : 1;
  std::fputs(
      "usage: make FACES OUT | subdivide IN N OUT | run FILE T REPEAT | plain FILE T REPEAT\n",
      stderr);
  return 2;
}
