#pragma once

#include <chrono>
#include <cstdio>
#include <deque>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "baking/bake_look.h"
#include "commands/look_obj_run.h"
#include "commands/obj_run.h"
#include "files/input_file.h"
#include "files/layout_text.h"
#include "files/out_of_memory.h"
#include "files/output_file.h"
#include "files/paths.h"
#include "terminal/terminal.h"

namespace abflat::cli {

/// Runs `work` of the core, which knows nothing of files, and prefixes errors with the input's
/// name.
template <class Work>
auto placed(const std::string& name, const Work& work) -> decltype(work()) {
  auto result = orOutOfMemory(name, work);
  // An out-of-memory message already names its place.
  if (!result.ok() && result.status().code != StatusCode::OutOfMemory)
    return Status{result.status().code, name + ": " + result.status().message};
  return result;
}

/// Options of baking for the layout of a command, if it is to bake.
template <class Command>
std::optional<BakeOptionValues> bakeOptions(const Command& command) {
  if (!command.baking.isWanted) return {};
  BakeOptionValues out = command.baking.options;
  out.threads = command.options.threads;
  return out;
}

/// A file that a command writes besides the mesh and the report.
template <class Outcome>
struct ExtraFile {
  std::string path;
  std::function<Result<std::string>(const PolygonMesh&, const Outcome&)> text;
};

/// One run from a mesh to the files that a command writes: the mesh with texcoords and, if wanted,
/// a report. `Job` provides
///   Command           with input, output, report, options and quiet
///   Outcome, Report   what the core returns, and the part of it that is written as JSON
///   kRepeated         see readInput
///   addNotes          adds notes to a report
///   gltf              how a glTF is read
///   keepsTexcoords    whether the result has all texcoords of that set
///   compute           from the mesh to a Result<Outcome>
///   json, summary, problem   texts of the report
///   triangleCorners   of a result and its mesh, as for makeGltf
///   turnFaces         turns the faces of the input that the result has turned, and returns them
///   kBakes            whether it can bake; if so, also
///   kMakesLayout      whether the layout is a new one
///   baking            options of baking, if that is asked for
///   newLayout         of an outcome
///   setBaking         puts what was baked into a report
///   extraFiles       further files, as a vector of ExtraFile<Outcome>
template <class Job>
class MeshRun {
 public:
  using Command = typename Job::Command;
  using Outcome = typename Job::Outcome;
  using Report = typename Job::Report;

  explicit MeshRun(const Command& command)
      : command_(command),
        isTalking_(!command.quiet && isErrorTerminal()),
        progress_(isTalking_),
        layout_(command.output) {
    if (!command.report.empty()) report_.emplace(command.report);
    for (const ExtraFile<Outcome>& file : Job::extraFiles(command)) {
      extras_.emplace_back(file.path);
      extraTexts_.push_back(file.text);
    }
  }

  int run() {
    if (Status s = checkTargets(); !s.ok()) return ended(s);
    Result<Outcome> result = computeFromInput();
    if (!result.ok()) return endedWithoutResult(result.status());
    if (Status s = writeAll(result.value()); !s.ok()) return ended(s);
    progress_.clear();
    const Report& report = result.value().report;
    if (isTalking_)
      std::fputs(
          Job::summary(report, inputName(command_.input), outputName(command_.output)).c_str(),
          stderr);
    if (report.valid) return static_cast<int>(ExitCode::Valid);
    complain(inputName(command_.input) +
             ": the layout was written, but is not valid: " + Job::problem(report));
    return static_cast<int>(ExitCode::NotValid);
  }

 private:
  using Clock = std::chrono::steady_clock;

  static double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  /// Done before the work, so that a wrong name costs no time.
  Status checkTargets() const {
    if (Status s = layout_.check(); !s.ok()) return s;
    for (const OutputFile& file : extras_)
      if (Status s = file.check(); !s.ok()) return s;
    return report_ ? report_->check() : Status{};
  }

  Result<Outcome> computeFromInput() {
    const std::string name = inputName(command_.input);
    progress_.show({Stage::Read, 0, 0, 0});
    Result<InputFile> input =
        readInput(command_.input, {Job::kRepeated, command_.allowsOutside, Job::gltf(command_)});
    readSeconds_ = secondsSince(start_);
    if (!input.ok()) return input.status();
    input_ = std::move(input.value());
    notes_ = input_.notes;
    if (input_.gltf && writtenFormat(command_.output) == FileFormat::Gltf) {
      noteCompression();
      chooseTexcoords();
    }
    // Names alone cannot tell if one of them has no extension or is a link.
    const FileFormat written = writtenFormat(command_.output);
    if (input_.format != written && command_.output != kStandardStream &&
        isSameTarget(command_.input, command_.output))
      return Status{StatusCode::InvalidOption,
                    name + ": the result is " + titleOf(written) + " and would replace this " +
                        titleOf(input_.format) + " file. Give --output another name"};
    if (Status s = readLookToBake(); !s.ok()) return s;
    return Job::compute(command_, input_.mesh, [this](const Progress& p) {
      progress_.show(p);
      return true;
    });
  }

  void noteCompression() {
    const std::string note = compressionNote(*input_.gltf);
    if (note.empty()) return;
    notes_.push_back(note);
    if (!command_.quiet) complainCleared({{}, note});
  }

  /// What a glTF made from another format does not hold, or holds in another way.
  void noteMade(const std::vector<std::uint32_t>& triangleCorners) {
    if (input_.gltf || writtenFormat(command_.output) != FileFormat::Gltf) return;
    notes_.insert(notes_.end(), input_.look.notes.begin(), input_.look.notes.end());
    const std::string note = originNote(input_.mesh, triangleCorners);
    if (note.empty()) return;
    notes_.push_back(note);
    if (!command_.quiet) complainCleared({{}, inputName(command_.input) + ": " + note});
  }

  bool isBaked() const {
    if constexpr (Job::kBakes) return Job::baking(command_).has_value();
    return false;
  }

  /// Done before the work, so that an image that is no image costs no time.
  Status readLookToBake() {
    if (!isBaked()) return {};
    if (!input_.gltf) return readObjToBake();
    if constexpr (Job::kBakes)
      if (writtenFormat(command_.output) == FileFormat::Obj) {
        lookObj_.emplace(command_.output, *Job::baking(command_));
        return lookObj_->read(input_, otherPaths());
      }
    Result<OldLook> look = orOutOfMemory(
        inputName(command_.input), [&] { return readOldLook(*input_.gltf, input_.readResource); });
    if (look.ok()) oldLook_ = std::move(look.value());
    return look.status();
  }

  Status readObjToBake() {
    if constexpr (Job::kBakes) {
      const std::string name = inputName(command_.input);
      if (input_.format == FileFormat::Ply && writtenFormat(command_.output) != FileFormat::Gltf)
        return {
            StatusCode::InvalidOption,
            name +
                " is a PLY. It can only be baked into a .glb or .gltf; give --output such a name"};
      if (input_.format != FileFormat::Obj && input_.format != FileFormat::Ply)
        return {StatusCode::InvalidOption, name + " is " + titleOf(input_.format) +
                                               ". Only a glTF, an OBJ or a PLY can be baked"};
      if (!Job::kMakesLayout)
        return {StatusCode::InvalidOption,
                name + " has only one layout. Use unwrap --bake or pack --bake"};
      obj_.emplace(command_.output, *Job::baking(command_), otherPaths());
      if (Status s = obj_->read(input_); !s.ok()) return s;
      const std::string lead = name + ": ";
      for (const std::string& note : obj_->leftOut()) {
        notes_.push_back(note);
        if (!command_.quiet) complainCleared({{}, std::string(lead).append(note)});
      }
    }
    return {};
  }

  /// What the command reads or writes besides new images.
  std::vector<std::string> otherPaths() const {
    std::vector<std::string> out = {command_.input, command_.output, command_.report};
    for (const ExtraFile<Outcome>& file : Job::extraFiles(command_)) out.push_back(file.path);
    return out;
  }

  /// Has textures of or in an OBJ follow its layout; `bake` does.
  template <class Run, class Bake>
  Status bakeObj(Run& run, Outcome& result, const Bake& bake) {
    const Result<bool> done = orOutOfMemory(inputName(command_.input), [&]() -> Result<bool> {
      Status s = bake(run);
      if (!s.ok()) return s;
      return true;
    });
    if (!done.ok()) return done.status();
    notes_.insert(notes_.end(), run.notes().begin(), run.notes().end());
    Job::setBaking(run.report(), result.report);
    return {};
  }

  /// The old look in the new layout, or nothing if it is not wanted.
  Result<std::optional<GltfBaked>> bakeFor(Outcome& result,
                                           const std::vector<std::uint32_t>& turned) {
    std::optional<GltfBaked> out;
    if constexpr (Job::kBakes) {
      const NewLayout layout = Job::newLayout(result, turned);
      if (obj_) {
        Status s = bakeObj(*obj_, result, [&](ObjRun& run) {
          return run.bake(input_, layout, Job::triangleCorners(input_.mesh, result));
        });
        if (!s.ok()) return s;
      }
      if (lookObj_) {
        Status s = bakeObj(*lookObj_, result,
                           [&](LookObjRun& run) { return run.bake(input_.mesh, layout); });
        if (!s.ok()) return s;
      }
      if (!oldLook_) return out;
      Result<NewLook> look = orOutOfMemory(inputName(command_.input), [&] {
        return bakeLook(*oldLook_, layout, *Job::baking(command_));
      });
      if (!look.ok()) return look.status();
      oldLook_.reset();
      notes_.insert(notes_.end(), look.value().notes.begin(), look.value().notes.end());
      Job::setBaking(look.value().report, result.report);
      out = std::move(look.value().baked);
    }
    return out;
  }

  /// Keeps textures of a glTF correct unless the user says otherwise.
  void chooseTexcoords() {
    const bool isChosen = command_.texcoord || Job::keepsTexcoords(command_);
    if (!isChosen) texcoord_ = freeTexcoord(*input_.gltf, isBaked());
    if (Job::keepsTexcoords(command_) && !command_.texcoord)
      texcoord_ = Job::gltf(command_).texcoord;
    if (texcoord_ > 0 && !isChosen) {
      notes_.push_back(texcoordNote(*input_.gltf, texcoord_));
      if (!command_.quiet) complainCleared({{}, inputName(command_.input) + ": " + notes_.back()});
    }
    if (isBaked()) return;
    for (const std::string& note : staleNotes(*input_.gltf, texcoord_)) notes_.push_back(note);
  }

  /// Adds what only the caller of the core knows.
  void complete(Report& report) const {
    report.path = command_.input;
    report.options = command_.options;
    Job::addNotes(notes_, report);
    report.timings.read = readSeconds_;
    report.timings.write = writeSeconds_;
    report.timings.total = secondsSince(start_);
  }

  /// All files are complete before any is given its name, and either all get theirs or none does.
  Status writeAll(Outcome& result) {
    progress_.show({Stage::Write, 0, 0, 0.98});
    const Clock::time_point begin = Clock::now();
    const std::string name = inputName(command_.input);
    const Result<std::vector<std::uint32_t>> turned =
        placed(name, [&]() -> Result<std::vector<std::uint32_t>> {
          if (writtenFormat(command_.output) == FileFormat::Gltf)
            if (Status s = readLook(input_); !s.ok()) return s;
          return Job::turnFaces(input_, result);
        });
    if (!turned.ok()) return turned.status();
    const Result<std::optional<GltfBaked>> baked = bakeFor(result, turned.value());
    if (!baked.ok()) return baked.status();
    Result<std::string> layout = placed(name, [&]() -> Result<std::string> {
      if constexpr (Job::kBakes)
        if (lookObj_) return lookObj_->text(input_.mesh, Job::newLayout(result, turned.value()));
      return layoutText(
          input_, command_.movedTo.empty() ? command_.output : command_.movedTo, texcoord_,
          {result.uv, result.cornerUv, Job::triangleCorners(input_.mesh, result), turned.value(),
           baked.value() ? &*baked.value() : nullptr, obj_.has_value()});
    });
    if (!layout.ok()) return layout.status();
    noteMade(Job::triangleCorners(input_.mesh, result));
    if (obj_) layout = obj_->named(std::move(layout).value());
    if (Status s = layout_.write(std::move(layout.value())); !s.ok()) return s;
    for (std::size_t i = 0; i < extras_.size(); ++i) {
      Result<std::string> text = placed(name, [&] { return extraTexts_[i](input_.mesh, result); });
      if (!text.ok()) return text.status();
      if (Status s = extras_[i].write(std::move(text.value())); !s.ok()) return s;
    }
    writeSeconds_ = secondsSince(begin);
    complete(result.report);
    std::vector<OutputFile*> files = {&layout_};
    for (OutputFile& file : extras_) files.push_back(&file);
    if (obj_)
      if (Status s = obj_->write(files); !s.ok()) return s;
    if (lookObj_)
      if (Status s = lookObj_->write(files); !s.ok()) return s;
    if (report_) {
      if (Status s = report_->write(Job::json(result.report)); !s.ok()) return s;
      files.push_back(&*report_);
    }
    return OutputFile::commit(files);
  }

  /// The report contains the error and everything known about the input.
  int endedWithoutResult(const Status& status) {
    if (report_) {
      Report report;
      report.error = status;
      if (exitCodeOf(status.code) != static_cast<int>(ExitCode::Unreadable) &&
          status.code != StatusCode::OutOfMemory)
        report.input = inspect(input_.mesh);
      complete(report);
      const Status written = report_->writeNow(Job::json(report));
      if (!written.ok()) complainCleared(written);
    }
    return ended(status);
  }

  int ended(const Status& status) {
    complainCleared(status);
    return exitCodeOf(status.code);
  }

  void complainCleared(const Status& status) {
    progress_.clear();
    complain(status.message);
  }

  const Command& command_;
  const Clock::time_point start_ = Clock::now();
  bool isTalking_;
  ProgressLine progress_;
  OutputFile layout_;
  std::optional<OutputFile> report_;
  std::deque<OutputFile> extras_;
  std::vector<std::function<Result<std::string>(const PolygonMesh&, const Outcome&)>> extraTexts_;
  InputFile input_;
  std::optional<OldLook> oldLook_;     ///< of a glTF that is baked into one
  std::optional<ObjRun> obj_;          ///< if an OBJ is to be baked
  std::optional<LookObjRun> lookObj_;  ///< if a glTF is to be baked into an OBJ
  std::vector<std::string> notes_;     ///< about reading and writing, one sentence each
  std::size_t texcoord_ = command_.texcoord.value_or(0);  ///< number of the glTF set to write
  double readSeconds_ = 0, writeSeconds_ = 0;
};

}  // namespace abflat::cli
