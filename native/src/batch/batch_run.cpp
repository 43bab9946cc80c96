#include "batch/batch_run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "batch/find_inputs.h"
#include "batch/resume.h"
#include "batch/task_runner.h"
#include "batch/work_folder.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

/// Tells work folders of parts apart.
std::string shardTag(const BatchCommand& command) {
  if (command.shards <= 1) return "whole";
  return std::to_string(command.shard) + "-of-" + std::to_string(command.shards);
}

bool isThere(const std::string& path) {
  std::error_code ignored;  // what cannot be looked up is not there
  return fs::exists(path, ignored);
}

}  // namespace

BatchRun::BatchRun(const BatchCommand& command)
    : command_(command),
      manifest_((fs::path(command.out) / manifestName(command.shard, command.shards)).string()) {}

std::string BatchRun::pathOf(const std::string& name) const {
  return (fs::path(command_.out) / name).string();
}

Status BatchRun::plan() {
  Result<std::vector<BatchInput>> inputs = findInputs(command_);
  if (!inputs.ok()) return inputs.status();
  Result<std::vector<Task>> tasks = planTasks(command_, std::move(inputs.value()));
  if (!tasks.ok()) return tasks.status();
  tasks_ = std::move(tasks.value());
  if (tasks_.empty()) return {StatusCode::UnreadableFile, "the list names no mesh"};
  if (Status s = keepShard(); !s.ok()) return s;
  if (Status s = checkFolder(); !s.ok()) return s;
  const std::string path = pathOf(manifestName(command_.shard, command_.shards));
  if (!isThere(path)) {
    chooseWanted({});
    return {};
  }
  const Result<ManifestLines> lines = readManifest(path);
  if (!lines.ok()) return lines.status();
  chooseWanted(lines.value());
  return {};
}

/// The content of a mesh decides in which part it is; where it cannot be read, its name.
Status BatchRun::keepShard() {
  if (command_.shards <= 1) return {};
  std::vector<Task> kept;
  for (Task& task : tasks_) {
    Result<Digest> digest = digestOf(task);
    if (digest.ok())
      task.inputHash = digest.value().text();
    else
      digest = Digest();
    if (task.inputHash.empty()) digest.value().add(task.name);
    if (digest.value().partOf(command_.shards) == command_.shard) kept.push_back(std::move(task));
  }
  tasks_ = std::move(kept);
  return {};
}

Status BatchRun::checkFolder() const {
  const std::string manifest = manifestName(command_.shard, command_.shards);
  if (isThere(pathOf(manifest))) {
    if (command_.resume) return {};
    return {StatusCode::InvalidOption, command_.out + " has the " + manifest +
                                           " of an earlier run. Add --resume to go on from it, or "
                                           "give --out another folder"};
  }
  for (const Task& task : tasks_)
    for (const std::string& output : task.outputs)
      if (isThere(pathOf(output)))
        return {StatusCode::InvalidOption, pathOf(output) +
                                               " is there already, from no batch. Give --out "
                                               "another folder"};
  return {};
}

void BatchRun::chooseWanted(const ManifestLines& lines) {
  wanted_.clear();
  for (std::size_t i = 0; i < tasks_.size(); ++i) {
    Task& task = tasks_[i];
    const auto line = lines.find(task.name);
    if (line != lines.end() && task.inputHash.empty())
      if (const Result<Digest> digest = digestOf(task); digest.ok())
        task.inputHash = digest.value().text();
    if (line == lines.end() || !isSettled(line->second, task, command_)) wanted_.push_back(i);
  }
  settled_ = tasks_.size() - wanted_.size();
}

std::string BatchRun::textOf(const Task& task) const {
  std::string out;
  if (task.isAtlas) out += command_.run + " into the atlas " + printable(task.name) + ":\n";
  for (std::size_t i = 0; i < task.inputs.size(); ++i) {
    out += (task.isAtlas ? "  " : command_.run + " ") + printable(task.inputs[i].path);
    if (!task.outputs.empty()) out += " -> " + printable(pathOf(task.outputs[i]));
    out += "\n";
  }
  return out;
}

std::string BatchRun::planText() const {
  std::string out;
  double most = 0;
  for (const std::size_t number : wanted_) {
    const Task& task = tasks_[number];
    out += textOf(task);
    most = std::max(most, task.memory);
  }
  const RunLimits limits = runLimits(command_);
  return out + std::to_string(wanted_.size()) + " to do, " + std::to_string(settled_) +
         " done already; " + std::to_string(limits.jobs) + " at once, within " +
         std::to_string(std::lround(limits.memory)) + " MB; the largest is predicted to need " +
         std::to_string(std::lround(most)) + " MB\n";
}

Status BatchRun::makeFolder() const {
  std::error_code error;
  fs::create_directories(command_.out, error);
  if (error)
    return {StatusCode::CannotWrite,
            "cannot create the folder " + command_.out + ": " + error.message()};
  return {};
}

Status BatchRun::run() {
  if (Status s = makeFolder(); !s.ok()) return s;
  if (Status s = manifest_.open(); !s.ok()) return s;
  chooseWanted(manifest_.lines());  // another run may have ended since
  WorkFolder work(command_.out, shardTag(command_));
  if (Status s = work.make(); !s.ok()) return s;
  TaskRunner runner(command_, tasks_, work);
  Status ran = runner.run(wanted_, [this](const ManifestLine& line) {
    removeOldFiles(manifest_.lines(), line, command_.out);
    return manifest_.add(line);
  });
  if (!ran.ok()) return ran;
  std::set<std::string> names;
  for (const Task& task : tasks_) names.insert(task.name);
  manifest_.keepOnly(names);
  return manifest_.sort();
}

}  // namespace abflat::cli
