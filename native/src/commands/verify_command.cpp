#include <chrono>
#include <cstdio>
#include <deque>

#include "abflat/draw.h"
#include "abflat/verify.h"
#include "commands/commands.h"
#include "files/compare_files.h"
#include "files/input_file.h"
#include "files/out_of_memory.h"
#include "files/output_file.h"
#include "files/paths.h"
#include "files/rules_file.h"
#include "reports/verify_reports.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class VerifyRun {
 public:
  explicit VerifyRun(const VerifyCommand& command)
      : command_(command),
        name_(inputName(command.input)),
        progress_(!command.quiet && isErrorTerminal()) {
    for (const std::string& path :
         {command.report, command.junit, command.sarif, command.picture}) {
      files_.emplace_back(path);
      isWanted_.push_back(!path.empty());
    }
  }

  int run() {
    for (std::size_t i = 0; i < files_.size(); ++i)
      if (isWanted(i))
        if (Status s = files_[i].check(); !s.ok()) return ended(s);
    Result<VerifyResult> result = verified();
    progress_.clear();
    if (!result.ok()) return ended(result.status());
    VerifyReport& report = result.value().report;
    report.timings.total = secondsSince(start_);
    if (Status s = write(report); !s.ok()) return ended(s);
    return static_cast<int>(report.valid ? ExitCode::Valid : ExitCode::NotValid);
  }

 private:
  bool isWanted(std::size_t file) const { return isWanted_[file] != 0; }

  Result<VerifyResult> verified() {
    VerifyOptions options;
    static_cast<VerifyOptionValues&>(options) = command_.options;
    if (!command_.rules.empty())
      if (Status s = readRules(command_.rules, command_.given, options); !s.ok()) return s;
    progress_.show({Stage::Read, 0, 0, 0});
    Result<InputFile> input = read(command_.input);
    if (!input.ok()) return input.status();
    const double read = secondsSince(start_);
    options.progress = [this](const Progress& p) {
      progress_.show(p);
      return true;
    };
    Result<VerifyResult> out =
        orOutOfMemory(name_, [&] { return verifyLayout(input.value().mesh, options); });
    if (!out.ok()) return Status{out.status().code, name_ + ": " + out.status().message};
    VerifyReport& report = out.value().report;
    report.path = command_.input;
    report.notes = input.value().notes;
    report.timings.read = read;
    if (!command_.against.empty())
      if (Status s = compare(input.value(), report); !s.ok()) return s;
    if (!command_.picture.empty())
      if (Status s = draw(input.value().mesh, out.value()); !s.ok()) return s;
    return out;
  }

  Result<InputFile> read(const std::string& path) const {
    return readInput(path, {Repeated::Stay, command_.allowsOutside, command_.gltf});
  }

  Status compare(InputFile& input, VerifyReport& report) const {
    Result<InputFile> was = read(command_.against);
    if (!was.ok()) return was.status();
    const Result<std::vector<MeshDifference>> differences = orOutOfMemory(
        name_, [&] { return compareFiles(was.value(), input, command_.gltf.texcoord); });
    if (!differences.ok()) return differences.status();
    report.against = command_.against;
    addDifferences(differences.value(), report);
    return {};
  }

  Status draw(const PolygonMesh& mesh, const VerifyResult& result) {
    Result<std::string> png = orOutOfMemory(name_, [&] { return verifyPng(mesh, result); });
    if (!png.ok()) return png.status();
    picture_ = std::move(png.value());
    return {};
  }

  Status write(const VerifyReport& report) {
    std::vector<OutputFile*> written;
    const auto add = [&](std::size_t file, std::string text) -> Status {
      if (!isWanted(file)) return {};
      written.push_back(&files_[file]);
      return files_[file].write(std::move(text));
    };
    if (Status s = add(0, verifyReportJson(report)); !s.ok()) return s;
    if (Status s = add(1, verifyJunit(report, name_)); !s.ok()) return s;
    if (Status s = add(2, verifySarif(report, name_)); !s.ok()) return s;
    if (Status s = add(3, std::move(picture_)); !s.ok()) return s;
    if (Status s = OutputFile::commit(written); !s.ok()) return s;
    const bool isTaken = command_.report == kStandardStream || command_.junit == kStandardStream ||
                         command_.sarif == kStandardStream || command_.picture == kStandardStream;
    if (command_.quiet || isTaken) return {};
    OutputFile out(kStandardStream);
    return out.writeNow(verifyText(report, name_));
  }

  int ended(const Status& status) {
    progress_.clear();
    complain(status.message);
    return exitCodeOf(status.code);
  }

  const VerifyCommand& command_;
  const std::string name_;
  const Clock::time_point start_ = Clock::now();
  ProgressLine progress_;
  std::deque<OutputFile> files_;  ///< the report, JUnit, SARIF and the picture
  std::vector<std::uint8_t> isWanted_;
  std::string picture_;
};

}  // namespace

int runVerify(const VerifyCommand& command) { return VerifyRun(command).run(); }

}  // namespace abflat::cli
