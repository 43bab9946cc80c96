#include "batch/task_runner.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <optional>
#include <thread>
#include <utility>

#include "batch/awaited_signals.h"
#include "batch/finished_task.h"
#include "batch/memory_model.h"
#include "files/atlas_parts.h"
#include "files/output_file.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

double workOfAll(const std::vector<Task>& tasks, const std::vector<std::size_t>& wanted) {
  double out = 0;
  for (const std::size_t task : wanted) out += BatchProgress::workOf(tasks[task]);
  return out;
}

std::size_t meshesOfAll(const std::vector<Task>& tasks, const std::vector<std::size_t>& wanted) {
  std::size_t out = 0;
  for (const std::size_t task : wanted) out += tasks[task].inputs.size();
  return out;
}

}  // namespace

RunLimits runLimits(const BatchCommand& command) {
  constexpr double kShare = 0.8, kUnknown = 4096;
  RunLimits out;
  out.jobs = command.jobs > 0 ? command.jobs : std::max(1u, std::thread::hardware_concurrency());
  const double free = freeMemory();
  out.memory = command.totalMemory > 0 ? command.totalMemory : free > 0 ? kShare * free : kUnknown;
  return out;
}

TaskRunner::TaskRunner(const BatchCommand& command, std::vector<Task>& tasks,
                       const WorkFolder& work)
    : command_(command),
      tasks_(tasks),
      work_(work),
      program_(ownProgram()),
      limits_(runLimits(command)) {
  for (const OptionOfCommand& option : optionsOfCommand(command.run))
    hasThreads_ = hasThreads_ || option.flag == "--threads";
}

TaskRunner::~TaskRunner() { endAll(); }

double TaskRunner::secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Status TaskRunner::run(const std::vector<std::size_t>& wanted, const OnEnd& onEnd) {
  const AwaitedSignals signals;
  Schedule schedule(tasks_, wanted, limits_.memory);
  BatchProgress progress(!command_.quiet && isErrorTerminal(), meshesOfAll(tasks_, wanted),
                         workOfAll(tasks_, wanted));
  threads_ = std::max<std::size_t>(1, limits_.jobs / std::max<std::size_t>(1, wanted.size()));
  while (!schedule.isEmpty() || !running_.empty() || !ended_.empty()) {
    // First, so that no processor waits for files to be moved.
    if (Status s = startAll(schedule); !s.ok()) return s;
    if (Status s = finishEnded(onEnd, progress); !s.ok()) return s;
    progress.show(running_.size());
    if (running_.empty()) continue;
    constexpr double kLongest = 1;
    signals.wait(command_.timeLimit > 0 ? std::min(kLongest, command_.timeLimit / 20) : kLongest);
    if (AwaitedSignals::asked() != 0)
      return {StatusCode::Aborted, "interrupted. The same command with --resume goes on from here"};
    endSlow();
    reap();
  }
  return {};
}

Status TaskRunner::startAll(Schedule& schedule) {
  while (running_.size() < limits_.jobs) {
    const std::optional<std::size_t> task = schedule.next(running_.size(), usedMemory_);
    if (!task) return {};
    if (Status s = start(*task, schedule.isAlone(*task)); !s.ok()) return s;
  }
  return {};
}

std::vector<std::string> TaskRunner::wordsFor(const Task& task, const WorkPlace& place,
                                              bool isAlone) const {
  std::vector<std::string> out = {"abflat", task.isAtlas ? "atlas" : command_.run, "--quiet",
                                  "--report=" + place.report};
  if (!task.isAtlas && !task.outputs.empty()) {
    out.push_back("--output=" + place.meshes.front());
    out.push_back("--moved-to=" + placeOf(task.outputs.front()));
  }
  if (!task.picture.empty())
    out.push_back((command_.run == "verify" ? "--picture=" : "--layout=") + place.layout);
  bool hasOwnThreads = !hasThreads_;
  for (const GivenOption& option : task.options) {
    hasOwnThreads = hasOwnThreads || option.flag == "--threads";
    out.push_back(option.value ? option.flag + "=" + *option.value : option.flag);
  }
  // Each thread reserves address space, which the limit is about.
  const bool hasOne = command_.memoryLimit > 0;
  const std::size_t threads = hasOne ? 1 : isAlone ? limits_.jobs : threads_;
  if (!hasOwnThreads) out.push_back("--threads=" + std::to_string(threads));
  out.insert(out.end(), {"--", task.isAtlas ? place.parts : task.inputs.front().path});
  return out;
}

std::string TaskRunner::placeOf(const std::string& output) const {
  return (std::filesystem::path(command_.out) / output).string();
}

Status TaskRunner::writeParts(const Task& task, const WorkPlace& place) const {
  if (!task.isAtlas) return {};
  std::vector<AtlasPart> parts;
  for (std::size_t i = 0; i < task.inputs.size(); ++i)
    parts.push_back({task.inputs[i].path, place.meshes[i], placeOf(task.outputs[i])});
  return OutputFile(place.parts).writeNow(atlasPartsText(parts));
}

Status TaskRunner::start(std::size_t number, bool isAlone) {
  Task& task = tasks_[number];
  if (task.inputHash.empty())
    if (const Result<Digest> digest = digestOf(task); digest.ok())
      task.inputHash = digest.value().text();
  const Result<WorkPlace> place = work_.placeFor(number, task);
  if (!place.ok()) return place.status();
  if (Status s = writeParts(task, place.value()); !s.ok()) return s;
  Running running;
  running.task = number;
  running.place = place.value();
  running.start = Clock::now();
  running.child = startChild(
      {program_, wordsFor(task, running.place, isAlone), running.place.said, command_.memoryLimit});
  if (running.child < 0)
    return {StatusCode::OutOfMemory,
            std::string("cannot start another process: ") + std::strerror(errno)};
  usedMemory_ += task.memory;
  running_.push_back(std::move(running));
  return {};
}

void TaskRunner::endSlow() {
  if (command_.timeLimit <= 0) return;
  for (Running& running : running_) {
    if (running.timeLimit > 0 || secondsSince(running.start) <= command_.timeLimit) continue;
    running.timeLimit = command_.timeLimit;
    kill(running.child, SIGKILL);
  }
}

void TaskRunner::reap() {
  for (auto running = running_.begin(); running != running_.end();) {
    const std::optional<ChildEnd> child = endOf(running->child);
    if (!child) {
      ++running;
      continue;
    }
    const double seconds = secondsSince(running->start);
    usedMemory_ -= tasks_[running->task].memory;
    ended_.push_back({std::move(*running), *child, seconds});
    running = running_.erase(running);
  }
  if (running_.empty()) usedMemory_ = 0;  // without what was rounded
}

Status TaskRunner::finishEnded(const OnEnd& onEnd, BatchProgress& progress) {
  for (const Ended& ended : ended_) {
    const ManifestLine line = finishedTask(
        tasks_[ended.was.task], ended.was.place,
        {ended.child, ended.seconds, ended.was.timeLimit, command_.memoryLimit}, command_.out);
    WorkFolder::remove(ended.was.place);
    progress.add(tasks_[ended.was.task], line.isGood());
    if (Status s = onEnd(line); !s.ok()) return s;
  }
  ended_.clear();
  return {};
}

void TaskRunner::endAll() {
  for (const Running& running : running_) kill(running.child, SIGKILL);
  for (const Running& running : running_)
    while (!endOf(running.child)) std::this_thread::yield();
  running_.clear();
}

}  // namespace abflat::cli
