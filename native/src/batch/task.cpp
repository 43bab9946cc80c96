#include "batch/task.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <unordered_map>

#include "batch/digest.h"
#include "batch/memory_model.h"
#include "files/file_format.h"
#include "files/paths.h"

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

/// The ending of a result.
std::string resultEnding(const BatchCommand& command, const std::string& name) {
  if (!command.ending.empty()) return command.ending;
  const std::string own = endingOf(name);
  return !own.empty() && isWritableName(name) ? own : ".glb";
}

/// Of the picture that is smaller: lines, or texels.
const char* pictureEnding(double faces) {
  constexpr double kMostDrawn = 10000;
  return faces <= kMostDrawn ? ".svg" : ".png";
}

/// The options of all meshes with those of one in their place, sorted.
std::vector<GivenOption> mergedOptions(const std::vector<GivenOption>& all,
                                       const std::vector<GivenOption>& own) {
  std::map<std::string, std::optional<std::string>> merged;
  for (const GivenOption& option : all) merged[option.flag] = option.value;
  for (const GivenOption& option : own) merged[option.flag] = option.value;
  std::vector<GivenOption> out;
  out.reserve(merged.size());
  for (const auto& [flag, value] : merged) out.push_back({flag, value});
  return out;
}

class TaskPlan {
 public:
  explicit TaskPlan(const BatchCommand& command) : command_(command) {
    for (const OptionOfCommand& option : optionsOfCommand(command.run))
      hasValue_[option.flag] = option.hasValue;
  }

  Result<std::vector<Task>> plan(std::vector<BatchInput> inputs) {
    // Those for all are checked even if each mesh has its own.
    if (const auto s = optionsHash(".obj", ".glb", withoutOff(mergedOptions(command_.options, {})));
        !s.ok())
      return s.status();
    std::vector<Task> out;
    for (BatchInput& input : inputs) {
      Result<Task> task = taskOf(std::move(input));
      if (!task.ok()) return task.status();
      out.push_back(std::move(task.value()));
    }
    return out;
  }

 private:
  /// In a list, a switch may be "true" or "false".
  std::vector<GivenOption> withoutOff(std::vector<GivenOption> options) const {
    std::vector<GivenOption> out;
    for (GivenOption& option : options) {
      const bool isSwitch = !hasValue_.at(option.flag);
      if (isSwitch && option.value == "false") continue;
      if (isSwitch) option.value.reset();
      out.push_back(std::move(option));
    }
    return out;
  }

  Result<Task> taskOf(BatchInput input) {
    Task task;
    const std::string ending = resultEnding(command_, input.name);
    if (command_.run != "verify")
      task.output = fs::path(input.name).replace_extension(ending).generic_string();
    task.options = withoutOff(mergedOptions(command_.options, input.options));
    const Result<std::string> hash = optionsHash(endingOf(input.name), ending, task.options);
    if (!hash.ok()) return placed(input, hash.status());
    task.optionsHash = hash.value();
    if (Status s = takePlace(task, input); !s.ok()) return s;
    measure(task, input);
    task.input = std::move(input);
    return task;
  }

  /// Names the mesh if it has options of its own.
  static Status placed(const BatchInput& input, const Status& status) {
    if (input.options.empty()) return status;
    return {status.code, input.path + ": " + status.message};
  }

  Status takePlace(const Task& task, const BatchInput& input) {
    const std::string& place = task.output.empty() ? input.name : task.output;
    const auto [other, isFree] = places_.try_emplace(place, input.path);
    if (isFree) return {};
    return {StatusCode::InvalidOption, other->second + " and " + input.path + " would both be " +
                                           (fs::path(command_.out) / place).string() +
                                           ". Rename one, or give them different folders"};
  }

  void measure(Task& task, const BatchInput& input) const {
    std::error_code unknown;  // then it cannot be read
    const std::uintmax_t bytes = fs::file_size(input.path, unknown);
    task.bytes = unknown ? 0 : bytes;
    const double faces = predictedFaces(input.path, task.bytes);
    task.memory = predictedMemory(faces, task.bytes);
    if (command_.pictures) task.picture = pictureOf(input, task.output, faces);
  }

  std::string pictureOf(const BatchInput& input, const std::string& output, double faces) const {
    if (command_.run == "unwrap" || command_.run == "pack")
      return "layouts/" + output + pictureEnding(faces);
    return command_.run == "verify" ? "layouts/" + input.name + ".png" : "";
  }

  /// Stands for all that a result depends on besides its mesh; checks the options. `from` and `to`
  /// are the endings of the mesh and of its result.
  Result<std::string> optionsHash(const std::string& from, const std::string& to,
                                  const std::vector<GivenOption>& options) {
    std::vector<std::string> words = {command_.run, "mesh" + from};
    if (command_.run != "verify") words.insert(words.end(), {"--output", "result" + to});
    std::string key = command_.run + "\n" + to + "\n";
    std::string all = from;
    for (const GivenOption& option : options) {
      words.push_back(option.value ? option.flag + "=" + *option.value : option.flag);
      // Results do not depend on it.
      if (option.flag != "--threads") key += words.back() + "\n";
      all += "\n" + words.back();
    }
    all += "\n" + to;
    if (const auto known = hashes_.find(all); known != hashes_.end()) return known->second;
    Result<std::string> hash = hashOf(key, words);
    if (hash.ok()) hashes_.emplace(std::move(all), hash.value());
    return hash;
  }

  /// Of a text, and of files that the command of these words reads.
  static Result<std::string> hashOf(const std::string& key, const std::vector<std::string>& words) {
    const Result<Command> parsed = parseWords(words);
    if (!parsed.ok()) return parsed.status();
    Digest digest;
    digest.add(key);
    for (const std::string& path : filesReadBy(parsed.value())) {
      if (path == kStandardStream)
        return Status{StatusCode::InvalidOption,
                      "many meshes cannot all read standard input. Name a file instead of -"};
      const Result<Digest> content = fileDigest(path);
      if (!content.ok()) return content.status();
      digest.add(content.value().text());
    }
    return digest.text();
  }

  const BatchCommand& command_;
  std::unordered_map<std::string, bool> hasValue_;
  std::unordered_map<std::string, std::string> hashes_;
  std::unordered_map<std::string, std::string> places_;
};

}  // namespace

Result<std::vector<Task>> planTasks(const BatchCommand& command, std::vector<BatchInput> inputs) {
  return TaskPlan(command).plan(std::move(inputs));
}

}  // namespace abflat::cli
