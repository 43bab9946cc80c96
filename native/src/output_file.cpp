#include "output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "arguments.h"
#include "leftovers.h"
#include "paths.h"

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxLinks = 40;
constexpr int kMaxNames = 100;

/// The file behind symbolic links, whether it exists or not.
std::string resolved(const std::string& path) {
  fs::path out = path;
  std::error_code error;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(out, error); ++i) {
    const fs::path next = fs::read_symlink(out, error);
    if (error) break;
    out = out.parent_path() / next;  // an absolute link replaces all before it
  }
  return out.string();
}

std::string folderOf(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// Empty, or why it failed.
std::string writeAll(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return std::strerror(errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

/// Owner (where that is allowed) and permissions of the file that will be replaced.
void takeOver(int file, const std::string& replaced) {
  struct stat old {};
  if (stat(replaced.c_str(), &old) != 0) return;
  const bool isMine = fchown(file, old.st_uid, old.st_gid) == 0;
  // A set-user-id bit must not move to another owner.
  fchmod(file, old.st_mode & (isMine ? 07777 : 0777));
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : name_(outputName(path)) {
  if (path == kStandardStream) {
    isDirect_ = true;
    return;
  }
  target_ = resolved(path);
  struct stat info {};
  isDirect_ = stat(target_.c_str(), &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode);
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  unlink(temporary_.c_str());
  keepOnSignal(temporary_);
}

Status OutputFile::failure(const std::string& reason) const {
  return {StatusCode::CannotWrite, "cannot write " + name_ + ": " + reason};
}

Status OutputFile::check() const {
  if (target_.empty()) return {};
  const std::string folder = folderOf(target_);
  std::error_code ignored;  // what cannot be looked up is not there
  if (fs::is_directory(target_, ignored)) return failure("it is a folder; name a file in it");
  if (!fs::is_directory(folder, ignored))
    return failure(fs::exists(folder, ignored) ? folder + " is not a folder"
                                               : "there is no folder " + folder);
  if (access(target_.c_str(), F_OK) == 0 && access(target_.c_str(), W_OK) != 0)
    return failure(std::strerror(errno));
  if (!isDirect_ && access(folder.c_str(), W_OK | X_OK) != 0)
    return failure(std::string(std::strerror(errno)) + " in folder " + folder);
  return {};
}

Status OutputFile::writeDirectly(std::string_view bytes) const {
  const int file = target_.empty() ? STDOUT_FILENO : open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return failure(std::strerror(errno));
  std::string problem = writeAll(file, bytes);
  if (file != STDOUT_FILENO && close(file) != 0 && problem.empty()) problem = std::strerror(errno);
  return problem.empty() ? Status{} : failure(problem);
}

/// -1 and errno on failure. Not mkstemp: a new file gets the permissions that umask asks for.
int OutputFile::openTemporary() {
  const SignalPause pause;
  for (int i = 0; i < kMaxNames; ++i) {
    const std::string name =
        ".abflat-" + std::to_string(getpid()) + "-" + std::to_string(i) + ".tmp";
    const std::string path = (fs::path(folderOf(target_)) / name).string();
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0 && errno == EEXIST) continue;
    if (file >= 0) {
      removeOnSignal(path);
      temporary_ = path;
    }
    return file;
  }
  return -1;
}

Status OutputFile::write(std::string_view bytes) {
  if (isDirect_) return writeDirectly(bytes);
  if (Status s = check(); !s.ok()) return s;
  const int file = openTemporary();
  if (file < 0) return failure(std::strerror(errno));
  takeOver(file, target_);
  std::string problem = writeAll(file, bytes);
  if (close(file) != 0 && problem.empty()) problem = std::strerror(errno);
  return problem.empty() ? Status{} : failure(problem);
}

Status OutputFile::commit() {
  if (temporary_.empty()) return {};
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) return failure(std::strerror(errno));
  keepOnSignal(temporary_);
  temporary_.clear();
  return {};
}

}  // namespace abflat::cli
