#include "reproduce/experiment.h"

#include <algorithm>
#include <filesystem>

#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "abflat/samples.h"
#include "files/file_format.h"
#include "files/input_file.h"
#include "files/out_of_memory.h"

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSamples[] = {"alpha-band", "three-balls", "head"};

/// A name that is safe in file names and URLs everywhere.
std::string plainName(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                         (c >= '0' && c <= '9') || c == '-' || c == '_' ||
                         (c == '.' && !out.empty());
    out += isPlain ? c : '-';
  }
  return out;
}

template <class Member>
void makeUnique(std::vector<Model>& models, Member member) {
  for (std::size_t i = 0; i < models.size(); ++i) {
    const std::string plain = models[i].*member;
    const auto isTaken = [&] {
      return std::any_of(models.begin(), models.begin() + static_cast<std::ptrdiff_t>(i),
                         [&](const Model& other) { return other.*member == models[i].*member; });
    };
    for (int n = 2; isTaken(); ++n) models[i].*member = plain + "-" + std::to_string(n);
  }
}

Status noMeshes(const std::string& folder, const std::string& reason) {
  return {StatusCode::UnreadableFile, "cannot read meshes from " + folder + ": " + reason};
}

Result<std::vector<fs::path>> meshFiles(const std::string& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) return noMeshes(folder, "there is no such folder");
  if (!fs::is_directory(folder, error))
    return noMeshes(folder, "it is not a folder. Name the folder of the meshes");
  std::vector<fs::path> out;
  fs::directory_iterator at(folder, error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    const std::optional<FileFormat> format = namedFormat(at->path().string());
    if (format && coreFormat(*format)) out.push_back(at->path());
  }
  if (error) return noMeshes(folder, error.message());
  if (out.empty()) return noMeshes(folder, std::string("it contains no ") + kCoreEndings + " file");
  std::sort(out.begin(), out.end());
  return out;
}

Result<InputFile> load(const Model& model) {
  if (!model.path.empty()) return readInput(model.path, {});
  return orOutOfMemory(model.name, [&]() -> Result<InputFile> {
    InputFile out;
    for (const Sample& sample : samples())
      if (sample.name == model.sample) out.mesh = sample.make(kMinSampleDetail);
    return out;
  });
}

}  // namespace

Result<std::vector<Model>> findModels(const std::string& folder) {
  std::vector<Model> out;
  for (const std::string_view sample : kSamples) {
    const std::string name(sample);
    out.push_back({name, name, "", sample, findPaperModel(name)});
  }
  if (!folder.empty()) {
    const Result<std::vector<fs::path>> files = meshFiles(folder);
    if (!files.ok()) return files.status();
    for (const fs::path& file : files.value()) {
      const std::string stem = file.stem().string();
      out.push_back({stem, plainName(stem), file.string(), {}, findPaperModel(stem)});
    }
  }
  makeUnique(out, &Model::name);
  makeUnique(out, &Model::fileStem);
  return out;
}

double secondsOf(const Report& report) {
  const Timings& s = report.timings;
  return s.connectivity + s.solve + s.layout + s.refine + s.check;
}

Experiment::Experiment(const Model& model) : model_(model) {
  Result<InputFile> input = load(model);
  status_ = input.status();
  if (!status_.ok()) return;
  mesh_ = std::move(input.value().mesh);
  summary_ = inspect(mesh_);
  status_ = summary_.disk;
}

const Result<FlattenResult>& Experiment::flattened(double t) {
  if (const auto found = results_.find(t); found != results_.end()) return found->second;
  FlattenOptions options;
  options.t = t;
  return results_.emplace(t, flattenedWith(options)).first->second;
}

Result<FlattenResult> Experiment::flattenedWith(const FlattenOptions& options) const {
  return orOutOfMemory(model_.name, [&] { return flatten(mesh_, options); });
}

}  // namespace abflat::cli
