#include "batch/finished_task.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "abflat/version.h"
#include "batch/digest.h"
#include "batch/report_summary.h"
#include "files/out_of_memory.h"
#include "files/read_file.h"

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

std::string numberWords(double x) {
  std::ostringstream out;
  out << x;
  return out.str();
}

/// The last sentence that the program has said of itself.
std::string reasonIn(const std::string& said) {
  const std::string lead = "abflat: ";
  std::istringstream lines(said);
  std::string out;
  for (std::string line; std::getline(lines, line);)
    if (line.compare(0, lead.size(), lead) == 0) out = line.substr(lead.size());
  return out;
}

MeshStatus statusOfExit(int code) {
  switch (static_cast<ExitCode>(code)) {
    case ExitCode::Valid:
      return MeshStatus::Done;
    case ExitCode::NotValid:
      return MeshStatus::NotValid;
    case ExitCode::Usage:
      return MeshStatus::Usage;
    case ExitCode::Unreadable:
      return MeshStatus::Unreadable;
    case ExitCode::NotFlattenable:
      return MeshStatus::NotFlattenable;
    case ExitCode::CannotWrite:
      return MeshStatus::CannotWrite;
  }
  return MeshStatus::Crashed;
}

void explainSignal(const TaskEnd& end, ManifestLine& line) {
  if (end.timeLimit > 0) {
    line.status = MeshStatus::TimeLimit;
    line.limit = end.timeLimit;
    line.message = "took longer than " + numberWords(end.timeLimit) + " s";
    return;
  }
  line.status = MeshStatus::Crashed;
  line.message = "was ended by signal " + std::to_string(end.child.signal) + " (" +
                 strsignal(end.child.signal) + ")";
}

void explainExit(const TaskEnd& end, const std::string& said, ManifestLine& line) {
  line.status = statusOfExit(end.child.exitCode);
  line.message = reasonIn(said);
  if (line.status == MeshStatus::Crashed)
    line.message = "ended with exit code " + std::to_string(end.child.exitCode) + ": " + said;
  if (!isOutOfMemory(line.message)) return;
  line.status = end.memoryLimit > 0 ? MeshStatus::MemoryLimit : MeshStatus::OutOfMemory;
  line.limit = end.memoryLimit;
  if (end.memoryLimit > 0)
    line.message = "needs more memory than " + numberWords(end.memoryLimit) + " MB";
}

Status moveFile(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  if (!error) fs::rename(from, to, error);
  if (!error) return {};
  return {StatusCode::CannotWrite, "cannot write " + to.string() + ": " + error.message()};
}

/// The files in the folder of a mesh, the mesh last, so that it never lacks what it needs.
std::vector<fs::path> filesOf(const fs::path& mesh) {
  std::vector<fs::path> out;
  std::error_code ignored;  // an empty list
  for (const fs::directory_entry& entry : fs::directory_iterator(mesh.parent_path(), ignored))
    if (entry.path() != mesh) out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  out.push_back(mesh);
  return out;
}

/// Moves a mesh and what it needs into a folder of results.
Status takeMesh(const fs::path& mesh, const fs::path& below, const fs::path& out,
                ManifestLine& line) {
  std::vector<WrittenFile> files;
  for (const fs::path& from : filesOf(mesh)) {
    const fs::path name = below / from.filename();
    const Result<Digest> digest = fileDigest(from.string());
    if (!digest.ok()) return digest.status();
    files.push_back({name.generic_string(), digest.value().text()});
    if (Status s = moveFile(from, out / name); !s.ok()) return s;
  }
  line.files.push_back(files.back());
  line.files.insert(line.files.end(), files.begin(), files.end() - 1);
  return {};
}

Status takeResults(const Task& task, const WorkPlace& place, const fs::path& out,
                   ManifestLine& line) {
  for (std::size_t i = 0; i < task.outputs.size(); ++i)
    if (Status s = takeMesh(place.meshes[i], fs::path(task.outputs[i]).parent_path(), out, line);
        !s.ok())
      return s;
  if (task.picture.empty()) return {};
  line.layout = task.picture;
  return moveFile(place.layout, out / line.layout);
}

/// Earlier results, be they of the same task, or of an atlas that the meshes shared.
void removeOutputs(const Task& task, const fs::path& out) {
  std::error_code ignored;  // there may be none
  for (const std::string& output : task.outputs) fs::remove(out / output, ignored);
}

ManifestLine lineOf(const Task& task) {
  ManifestLine out;
  out.name = task.name;
  out.isAtlas = task.isAtlas;
  for (const BatchInput& input : task.inputs) out.inputs.push_back(input.path);
  out.inputHash = task.inputHash;
  out.optionsHash = task.optionsHash;
  out.version = ABFLAT_VERSION;
  return out;
}

}  // namespace

ManifestLine finishedTask(const Task& task, const WorkPlace& place, const TaskEnd& end,
                          const std::string& out) {
  ManifestLine line = lineOf(task);
  line.seconds = end.seconds;
  line.peakMemory = end.child.peakMemory;
  const Result<std::string> said = readBytes(place.said);
  if (end.child.signal != 0)
    explainSignal(end, line);
  else
    explainExit(end, said.ok() ? said.value() : "", line);
  if (line.status != MeshStatus::Done && line.status != MeshStatus::NotValid) {
    removeOutputs(task, out);
    return line;
  }
  const Result<std::string> report = readBytes(place.report);
  if (report.ok()) line.summary = reportSummary(report.value());
  if (line.message.empty()) line.message = firstFinding(line.summary);
  const Status taken = takeResults(task, place, out, line);
  if (taken.ok()) return line;
  line.status = MeshStatus::CannotWrite;
  line.message = taken.message;
  return line;
}

}  // namespace abflat::cli
