#include "batch/task.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <unordered_map>

#include "batch/digest.h"
#include "batch/memory_model.h"
#include "batch/mesh_digest.h"
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
    if (const auto s = optionsHash(wordsFor(".obj", ".glb"), ".glb",
                                   withoutOff(mergedOptions(command_.options, {})));
        !s.ok())
      return s.status();
    std::vector<Task> out;
    for (std::vector<BatchInput>& group : grouped(std::move(inputs))) {
      Result<Task> task = taskOf(std::move(group));
      if (!task.ok()) return task.status();
      out.push_back(std::move(task.value()));
    }
    std::sort(out.begin(), out.end(), [](const Task& a, const Task& b) { return a.name < b.name; });
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

  /// Meshes of one atlas together, and each of the others.
  static std::vector<std::vector<BatchInput>> grouped(std::vector<BatchInput> inputs) {
    std::vector<std::vector<BatchInput>> out;
    std::unordered_map<std::string, std::size_t> atlases;
    for (BatchInput& input : inputs) {
      const auto [atlas, isNew] = atlases.try_emplace(input.atlas, out.size());
      if (input.atlas.empty() || isNew) out.emplace_back();
      (input.atlas.empty() ? out.back() : out[atlas->second]).push_back(std::move(input));
    }
    return out;
  }

  Result<Task> taskOf(std::vector<BatchInput> inputs) {
    const BatchInput& first = inputs.front();
    Task task;
    task.isAtlas = !first.atlas.empty();
    task.name = task.isAtlas ? first.atlas : first.name;
    task.options = withoutOff(mergedOptions(command_.options, first.options));
    if (Status s = checkTogether(task, inputs); !s.ok()) return s;
    std::string endings;
    for (const BatchInput& input : inputs) {
      const std::string ending = resultEnding(command_, input.name);
      endings += ending;
      if (command_.run != "verify")
        task.outputs.push_back(fs::path(input.name).replace_extension(ending).generic_string());
      if (Status s = takePlace(task.outputs.empty() ? input.name : task.outputs.back(), input.path);
          !s.ok())
        return s;
    }
    if (Status s = takeName(task, first.path); !s.ok()) return s;
    const Result<std::string> hash =
        optionsHash(task.isAtlas ? std::vector<std::string>{"atlas", "parts"}
                                 : wordsFor(endingOf(first.name), endings),
                    endings, task.options);
    if (!hash.ok()) return placed(first, hash.status());
    task.optionsHash = hash.value();
    task.inputs = std::move(inputs);
    measure(task);
    return task;
  }

  Status checkTogether(const Task& task, const std::vector<BatchInput>& inputs) const {
    if (task.isAtlas && command_.run != "unwrap")
      return {StatusCode::InvalidOption, "only unwrap lays several meshes in one atlas, not " +
                                             command_.run + ". Leave out --atlas"};
    for (const BatchInput& input : inputs)
      if (!hasSameOptions(input, inputs.front()))
        return {StatusCode::InvalidOption, inputs.front().path + " and " + input.path +
                                               " share an atlas, but have different options"};
    return {};
  }

  /// Meshes of one name would have one place, so only an atlas can have that of a mesh.
  Status takeName(const Task& task, const std::string& path) {
    const auto [other, isFree] = names_.try_emplace(task.name, path);
    if (isFree) return {};
    return {StatusCode::InvalidOption, "an atlas and the mesh " +
                                           (task.isAtlas ? other->second : path) +
                                           " are both named " + task.name + ". Rename one"};
  }

  /// Names the mesh if it has options of its own.
  static Status placed(const BatchInput& input, const Status& status) {
    if (input.options.empty()) return status;
    return {status.code, input.path + ": " + status.message};
  }

  Status takePlace(const std::string& place, const std::string& path) {
    const auto [other, isFree] = places_.try_emplace(place, path);
    if (isFree) return {};
    return {StatusCode::InvalidOption, other->second + " and " + path + " would both be " +
                                           (fs::path(command_.out) / place).string() +
                                           ". Rename one, or give them different folders"};
  }

  void measure(Task& task) const {
    double faces = 0;
    for (const BatchInput& input : task.inputs) {
      std::error_code unknown;  // then it cannot be read
      const std::uintmax_t bytes = fs::file_size(input.path, unknown);
      if (unknown) continue;
      task.bytes += bytes;
      faces += predictedFaces(input.path, bytes);
    }
    task.memory = predictedMemory(faces, task.bytes);
    if (command_.pictures) task.picture = pictureOf(task, faces);
  }

  std::string pictureOf(const Task& task, double faces) const {
    if (task.isAtlas) return "layouts/" + task.name + pictureEnding(faces);
    if (command_.run == "unwrap" || command_.run == "pack")
      return "layouts/" + task.outputs.front() + pictureEnding(faces);
    return command_.run == "verify" ? "layouts/" + task.name + ".png" : "";
  }

  /// A command for one mesh. `from` and `to` are the endings of the mesh and of its result.
  std::vector<std::string> wordsFor(const std::string& from, const std::string& to) const {
    std::vector<std::string> out = {command_.run, "mesh" + from};
    if (command_.run != "verify") out.insert(out.end(), {"--output", "result" + to});
    return out;
  }

  /// Stands for all that results depend on besides their meshes; checks the options. `words` are
  /// those of the command without options, `to` the endings of results.
  Result<std::string> optionsHash(std::vector<std::string> words, const std::string& to,
                                  const std::vector<GivenOption>& options) {
    std::string key = words.front() + "\n" + to + "\n";
    std::string all = words.at(1) + "\n" + key;
    for (const GivenOption& option : options) {
      words.push_back(option.value ? option.flag + "=" + *option.value : option.flag);
      // Results do not depend on it.
      if (option.flag != "--threads") key += words.back() + "\n";
      all += words.back() + "\n";
    }
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
  std::unordered_map<std::string, std::string> places_;  ///< of results
  std::unordered_map<std::string, std::string> names_;
};

}  // namespace

Result<Digest> digestOf(const Task& task) {
  return task.isAtlas ? atlasDigest(task.inputs) : meshDigest(task.inputs.front().path);
}

Result<std::vector<Task>> planTasks(const BatchCommand& command, std::vector<BatchInput> inputs) {
  return TaskPlan(command).plan(std::move(inputs));
}

}  // namespace abflat::cli
