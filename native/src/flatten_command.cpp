#include <chrono>
#include <cstdio>
#include <optional>
#include <utility>

#include "abflat/flatten.h"
#include "bounds_file.h"
#include "commands.h"
#include "input_file.h"
#include "mesh_format.h"
#include "out_of_memory.h"
#include "output_file.h"
#include "paths.h"
#include "terminal.h"
#include "texts.h"

namespace abflat::cli {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// One run from the input to the files it writes.
class FlattenRun {
 public:
  explicit FlattenRun(const FlattenCommand& command)
      : command_(command),
        isTalking_(!command.quiet && isErrorTerminal()),
        progress_(isTalking_),
        layout_(command.output) {
    if (!command.report.empty()) report_.emplace(command.report);
  }

  int run() {
    if (Status s = checkTargets(); !s.ok()) return ended(s);
    Result<FlattenResult> result = flattenInput();
    if (!result.ok()) return endedWithoutResult(result.status);
    if (Status s = writeAll(result.value); !s.ok()) return ended(s);
    progress_.clear();
    const Report& report = result.value.report;
    if (isTalking_)
      std::fputs(resultText(report, inputName(command_.input), outputName(command_.output)).c_str(),
                 stderr);
    if (report.valid) return static_cast<int>(ExitCode::Valid);
    complain(inputName(command_.input) +
             ": the layout is written, but not valid: " + report.charts.front().problem);
    return static_cast<int>(ExitCode::NotValid);
  }

 private:
  /// Before the work, so that a wrong name costs no time.
  Status checkTargets() const {
    if (Status s = layout_.check(); !s.ok()) return s;
    return report_ ? report_->check() : Status{};
  }

  Result<FlattenResult> flattenInput() {
    const std::string name = inputName(command_.input);
    progress_.show({"read", 0, 0, 0});
    Result<InputMesh> input = readInput(command_.input);
    readSeconds_ = secondsSince(start_);
    if (!input.ok()) return input.status;
    input_ = std::move(input.value);
    // The names cannot tell when one of them has no ending or is a link.
    const MeshFormat written = writtenFormat(command_.output);
    if (input_.format != written && command_.output != kStandardStream &&
        isSameTarget(command_.input, command_.output))
      return Status{StatusCode::InvalidOption,
                    name + ": the result is " + formatName(written) + " and would replace this " +
                        formatName(input_.format) + " file; give --output another name"};
    FlattenOptions options;
    static_cast<FlattenOptionValues&>(options) = command_.options;
    if (!command_.bounds.empty()) {
      Result<std::vector<VertexBound>> bounds = readBounds(command_.bounds);
      if (!bounds.ok()) return bounds.status;
      options.bounds = std::move(bounds.value);
    }
    options.progress = [this](const Progress& p) {
      progress_.show(p);
      return true;
    };
    Result<FlattenResult> result =
        orOutOfMemory(name, [&] { return flatten(input_.mesh, options); });
    // Lack of memory is worded with its place already.
    if (!result.ok() && result.status.code != StatusCode::OutOfMemory)
      result.status.message = name + ": " + result.status.message;
    return result;
  }

  /// Adds what only the caller of the core knows.
  void complete(Report& report) const {
    report.path = command_.input;
    report.options = command_.options;
    report.timings.read = readSeconds_;
    report.timings.write = writeSeconds_;
    report.timings.total = secondsSince(start_);
  }

  /// Both files are complete before either gets its name.
  Status writeAll(FlattenResult& result) {
    progress_.show({"write", 0, 0, 0.98});
    if (writtenFormat(command_.output) == MeshFormat::Ply)
      roundToSinglePrecision(input_.mesh, result);
    const Clock::time_point begin = Clock::now();
    if (Status s = layout_.write(layoutText(input_, command_.output, result.uv, result.cornerUv));
        !s.ok())
      return s;
    writeSeconds_ = secondsSince(begin);
    complete(result.report);
    if (report_)
      if (Status s = report_->write(reportJson(result.report)); !s.ok()) return s;
    if (Status s = layout_.commit(); !s.ok()) return s;
    return report_ ? report_->commit() : Status{};
  }

  /// What is known about the input goes into the report with the error.
  int endedWithoutResult(const Status& status) {
    if (report_) {
      Report report;
      report.error = status;
      if (exitCodeOf(status.code) != static_cast<int>(ExitCode::Unreadable) &&
          status.code != StatusCode::OutOfMemory)
        report.input = inspect(input_.mesh);
      complete(report);
      Status written = report_->write(reportJson(report));
      if (written.ok()) written = report_->commit();
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

  const FlattenCommand& command_;
  const Clock::time_point start_ = Clock::now();
  bool isTalking_;
  ProgressLine progress_;
  OutputFile layout_;
  std::optional<OutputFile> report_;
  InputMesh input_;
  double readSeconds_ = 0, writeSeconds_ = 0;
};

}  // namespace

int runFlatten(const FlattenCommand& command) { return FlattenRun(command).run(); }

}  // namespace abflat::cli
