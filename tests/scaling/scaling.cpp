// Counts the steps that each stage takes for meshes of two sizes, as JSON:
// [{"family", "stage", "faces": [n, n], "steps": [n, n]}, ...]
// Usage: abflat_scaling FACES TIMES [FAMILY ...]

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "abflat/gltf.h"
#include "abflat/unwrap.h"
#include "families.h"
#include "steps.h"

namespace {

using namespace abflat;
using scaling::stepsSoFar;
using StageSteps = std::map<std::string, std::uint64_t>;

/// Runs a function and returns its steps.
template <class Run>
std::uint64_t stepsOf(Run run) {
  const std::uint64_t before = stepsSoFar();
  run();
  return stepsSoFar() - before;
}

/// Steps between one call for progress and the next belong to the stage that the first one names.
class StageCounter {
 public:
  explicit StageCounter(StageSteps& steps, std::string prefix)
      : steps_(steps), prefix_(std::move(prefix)), since_(stepsSoFar()) {}
  ~StageCounter() { enter(""); }

  void enter(const char* stage) {
    if (!stage_.empty()) steps_[prefix_ + stage_] += stepsSoFar() - since_;
    stage_ = stage;
    since_ = stepsSoFar();
  }

 private:
  StageSteps& steps_;
  std::string prefix_, stage_ = "begin";
  std::uint64_t since_;
};

void countFiles(const PolygonMesh& mesh, const UnwrapResult& atlas, StageSteps& out) {
  std::string obj, ply;
  out["write OBJ"] = stepsOf([&] { obj = writeObj(mesh, atlas.uv, atlas.cornerUv, {}); });
  out["read OBJ"] = stepsOf([&] { readMesh(obj, MeshFormat::Obj, "mesh"); });
  out["write PLY"] = stepsOf([&] { ply = writePly(mesh, atlas.uv, atlas.cornerUv, {}); });
  out["read PLY"] = stepsOf([&] { readMesh(ply, MeshFormat::Ply, "mesh"); });
  std::string glb;
  out["write GLB"] = stepsOf([&] {
    glb = makeGltf(mesh, atlas.uv, atlas.cornerUv, atlas.triangleCorners, {}, {}).value();
  });
  out["read GLB"] = stepsOf([&] {
    readGltf(glb, "mesh", [](const std::string&) { return Result<std::string>(std::string()); });
  });
}

StageSteps countSteps(const PolygonMesh& mesh) {
  StageSteps out;
  out["inspect"] = stepsOf([&] { inspect(mesh); });
  const Result<UnwrapResult> atlas = [&] {
    StageCounter counter(out, "unwrap ");
    UnwrapOptions options;
    options.threads = 1;
    options.progress = [&](const Progress& p) {
      counter.enter(nameOf(p.stage));
      return true;
    };
    return unwrap(mesh, options);
  }();
  if (!atlas.ok()) {
    std::fprintf(stderr, "%s\n", atlas.status().message.c_str());
    std::exit(1);
  }
  countFiles(mesh, atlas.value(), out);
  StageCounter counter(out, "flatten ");
  FlattenOptions options;
  options.threads = 1;
  options.progress = [&](const Progress& p) {
    counter.enter(nameOf(p.stage));
    return true;
  };
  flatten(mesh, options);  // most families are refused, at some cost
  return out;
}

bool isAsked(const char* name, int count, char** names) {
  for (int i = 0; i < count; ++i)
    if (std::strcmp(names[i], name) == 0) return true;
  return count == 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: abflat_scaling FACES TIMES [FAMILY ...]\n");
    return 2;
  }
  const auto faces = static_cast<unsigned>(std::strtoul(argv[1], nullptr, 10));
  const auto times = static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10));
  nlohmann::json rows = nlohmann::json::array();
  for (const scaling::Family& family : scaling::families()) {
    if (!isAsked(family.name, argc - 3, argv + 3)) continue;
    const PolygonMesh small = family.make(faces), large = family.make(faces * times);
    const StageSteps few = countSteps(small);
    for (const auto& [stage, steps] : countSteps(large)) {
      const auto before = few.find(stage);
      rows.push_back({{"family", family.name},
                      {"stage", stage},
                      {"faces", {small.faceVertices.size() / 3, large.faceVertices.size() / 3}},
                      {"steps", {before == few.end() ? 0 : before->second, steps}}});
    }
  }
  std::printf("%s\n", rows.dump().c_str());
  return 0;
}
