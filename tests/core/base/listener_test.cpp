#include "base/listener.h"

#include <atomic>
#include <cmath>
#include <map>
#include <random>
#include <string>

#include "abflat/unwrap.h"
#include "base/parallel.h"
#include "catch.h"
#include "mesh/surface.h"
#include "mesh/welded_mesh.h"
#include "support/instrumented.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Separate triangles of a sheet, with corners displaced by less than the tolerance.
PolygonMesh looseSheet(unsigned n) {
  const PolygonMesh grid = bumpyGrid(n, n, 0.1, 3);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> shift(-1e-8, 1e-8);
  PolygonMesh out;
  out.faceOffsets = grid.faceOffsets;
  for (const std::size_t v : grid.faceVertices) {
    out.faceVertices.push_back(static_cast<std::uint32_t>(out.faceVertices.size()));
    for (std::size_t d = 0; d < 3; ++d)
      out.positions.push_back(grid.positions[3 * v + d] + shift(random));
  }
  return out;
}

PolygonMesh zigzag(unsigned n) {
  PolygonMesh out;
  for (unsigned k = 0; k < n; ++k) {
    const double angle = 6.283185307179586 * k / n, r = k % 2 ? 1 : 0.9;
    out.positions.insert(out.positions.end(), {r * std::cos(angle), r * std::sin(angle), 0});
    out.faceVertices.push_back(k);
  }
  out.faceOffsets = {0, n};
  return out;
}

}  // namespace

TEST_CASE("a listener is told after a number of steps, and no more once it has stopped") {
  int told = 0;
  const Listener listener([&](const Progress&) { return ++told < 3; });
  std::size_t steps = 0;
  while (listener.beat() && steps < 10000000) ++steps;
  CHECK(told == 3);
  CHECK(steps > 50000);
  CHECK(steps < 1000000);
  CHECK(listener.isStopped());
  for (int i = 0; i < 100000; ++i) CHECK_FALSE(listener.beat());
  CHECK(told == 3);
  CHECK(Listener().beat(std::size_t{1} << 40));
}

TEST_CASE("parts of a listener report their share of the whole, which never goes back") {
  Progress last;
  const Listener run([&](const Progress& now) {
    last = now;
    return true;
  });
  const Listener solving = run.part(Stage::Solve, 0.2, 0.6);
  CHECK(solving.tell(0.25));
  CHECK(last.stage == Stage::Solve);
  CHECK(last.fraction == Approx(0.3));
  solving.part(0.5, 1).tell(0.5);
  CHECK(last.fraction == Approx(0.5));
  solving.tell(0.25);
  CHECK(last.fraction == Approx(0.5));
  run.part(Stage::Pack, 0.6, 1).tell();
  CHECK(last.stage == Stage::Pack);
  CHECK(last.fraction == Approx(0.6));
  run.tell();
  CHECK(last.stage == Stage::Pack);
}

TEST_CASE("the share of work of unknown amount grows, without ever reaching all", "[progress]") {
  constexpr int kUsual = 40;
  double last = 0;
  const Listener run([&](const Progress& now) {
    CHECK(now.fraction > last);
    CHECK(now.fraction < 1);
    last = now.fraction;
    return true;
  });
  const Listener work = run.approach(kUsual), same = work;
  for (int step = 1; step <= 100 * kUsual; ++step) {
    (step % 2 ? work : same).tell();
    if (step == kUsual) CHECK(last == 0.5);
  }
}

TEST_CASE("stages and steps within a stage are not reported", "[progress]") {
  Progress last;
  const Listener run([&](const Progress& now) {
    last = now;
    return true;
  });
  const Listener inStage = run.at(Stage::Pack);
  inStage.at(Stage::Layout).tell();
  inStage.tellStep(3, 0.5);
  CHECK(last.stage == Stage::Pack);
  CHECK(last.newtonStep == 0);
  run.at(Stage::Layout).tell();
  CHECK(last.stage == Stage::Layout);
  run.tellStep(3, 0.5);
  CHECK(last.stage == Stage::Solve);
  CHECK(last.newtonStep == 3);
  CHECK(last.constraintResidual == 0.5);
}

TEST_CASE("whoever hears that a run is to stop, all know, and only its own thread reports") {
  int told = 0;
  const Listener run([&](const Progress&) { return ++told < 3; });
  const Listener part = run.part(0, 0.5).approach(1);
  ThreadPool pool(3);
  parallelFor(&pool, 2, [&](std::size_t) { run.tell(); });
  CHECK(told <= 2);
  while (part.tell()) {
  }
  CHECK(told == 3);
  CHECK(run.isStopped());
  CHECK_FALSE(run.tell(1));
  CHECK(told == 3);
  std::atomic<int> going{0};
  parallelFor(&pool, 20, [&](std::size_t) { going += part.tell(); });
  CHECK(going == 0);
}

TEST_CASE("seeing a surface is heard of all the way, and ends wherever that is asked for") {
  for (const PolygonMesh& mesh : {looseSheet(150), zigzag(20000)}) {
    const auto see = [&](int most) {
      int asked = 0;
      const Listener listener([&](const Progress&) { return ++asked != most; });
      const MeshSummary input = inspect(mesh, listener);
      if (!listener.isStopped()) {
        const WeldedMesh welded = weld(mesh, !input.disk.ok(), listener);
        if (!listener.isStopped()) buildSurface(welded.mesh, listener);
      }
      CHECK(listener.isStopped() == (most > 0));
      return asked;
    };
    const int all = see(0);
    CHECK(all > 10);
    for (int most = 1; most <= all; most += 1 + all / 12) CHECK(see(most) == most);
  }
}

TEST_CASE("a run that is cancelled while it sees the surface ends there") {
  const PolygonMesh mesh = looseSheet(100);
  for (const int most : {1, 2, 4}) {
    int calls = 0;
    const ProgressCallback stop = [&](const Progress& p) {
      CHECK((p.stage == Stage::Surface || p.stage == Stage::Connectivity));
      return ++calls != most;
    };
    UnwrapOptions options;
    options.progress = stop;
    CHECK(unwrap(mesh, options).status().code == StatusCode::Aborted);
    CHECK(calls == most);
    if (most > 2) continue;  // a disk is examined only once
    calls = 0;
    FlattenOptions disk;
    disk.progress = stop;
    CHECK(flatten(zigzag(5000), disk).status().code == StatusCode::Aborted);
    CHECK(calls == most);
  }
}

TEST_CASE("calls become more with the mesh while seams are sought and charts flattened",
          "[quality]") {
  const auto calls = [](unsigned n, int threads) {
    std::map<Stage, int> out;
    double fraction = 0;
    bool isMonotone = true;
    UnwrapOptions options;
    options.threads = threads;
    options.balance = 0;  // refining ends by its gain, not by size
    options.minUtilization = 0;
    options.progress = [&](const Progress& p) {
      ++out[p.stage];
      isMonotone = isMonotone && p.fraction >= fraction;
      fraction = p.fraction;
      return true;
    };
    CHECK(unwrap(torus(n, n), options).ok());
    CHECK(isMonotone);
    return out;
  };
  // Smaller meshes are cut in several ways.
  std::map<Stage, int> few = calls(101, 1), many = calls(cases(300u, 240u), 1);
  // There are six to nine times as many triangles.
  CHECK(many[Stage::Seams] > cases(3, 2) * few[Stage::Seams]);
  CHECK(many[Stage::Solve] > 2 * few[Stage::Solve]);
  CHECK(calls(cases(180u, 150u), 2)[Stage::Seams] > few[Stage::Seams]);
}
