#include "batch/resume.h"

#include <algorithm>
#include <filesystem>

#include "abflat/version.h"
#include "batch/digest.h"

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

bool isUnchanged(const WrittenFile& file, const fs::path& out) {
  const Result<Digest> digest = fileDigest((out / file.path).string());
  return digest.ok() && digest.value().text() == file.hash;
}

bool hasFile(const ManifestLine& line, const std::string& path) {
  return std::any_of(line.files.begin(), line.files.end(),
                     [&](const WrittenFile& file) { return file.path == path; });
}

/// Whether a mesh that needed more than `old` would need more than `now` as well, where 0 is no
/// limit.
bool staysTooMuch(double old, double now) { return now > 0 && now <= old; }

bool isSettledStatus(const ManifestLine& line, const BatchCommand& command) {
  switch (line.status) {
    case MeshStatus::Done:
    case MeshStatus::NotValid:
    case MeshStatus::Usage:
    case MeshStatus::Unreadable:
    case MeshStatus::NotFlattenable:
      return true;
    case MeshStatus::TimeLimit:
      return staysTooMuch(line.limit, command.timeLimit);
    case MeshStatus::MemoryLimit:
      return staysTooMuch(line.limit, command.memoryLimit);
    case MeshStatus::CannotWrite:
    case MeshStatus::OutOfMemory:
    case MeshStatus::Crashed:
      return false;  // another machine, or another day, may do
  }
  return false;
}

}  // namespace

bool isSettled(const ManifestLine& line, const Task& task, const BatchCommand& command) {
  if (line.version != ABFLAT_VERSION || line.optionsHash != task.optionsHash) return false;
  if (line.inputHash.empty() || line.inputHash != task.inputHash) return false;
  if (!isSettledStatus(line, command)) return false;
  const fs::path out = command.out;
  std::error_code ignored;  // a picture that cannot be looked up is missing
  if (!line.layout.empty() && !fs::exists(out / line.layout, ignored)) return false;
  return std::all_of(line.files.begin(), line.files.end(),
                     [&](const WrittenFile& file) { return isUnchanged(file, out); });
}

void removeOldFiles(const ManifestLines& lines, const ManifestLine& now, const std::string& out) {
  const auto found = lines.find(now.name);
  if (found == lines.end()) return;
  const ManifestLine& old = found->second;
  std::error_code ignored;  // it may be gone
  for (const WrittenFile& file : old.files) {
    if (hasFile(now, file.path)) continue;
    // A mesh that has moved to another atlas may have its new result already.
    const bool isOfOther = std::any_of(lines.begin(), lines.end(), [&](const auto& line) {
      return line.first != now.name && hasFile(line.second, file.path);
    });
    if (!isOfOther) fs::remove(fs::path(out) / file.path, ignored);
  }
  if (!old.layout.empty() && old.layout != now.layout)
    fs::remove(fs::path(out) / old.layout, ignored);
}

}  // namespace abflat::cli
