#include "files/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <utility>

#include "files/leftovers.h"
#include "files/paths.h"
#include "files/system_call.h"

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxLinks = 40;
constexpr int kMostNames = 100;

/// The file that symbolic links lead to, whether it exists or not.
std::string resolved(const std::string& path) {
  fs::path out = path;
  std::error_code error;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(out, error); ++i) {
    const fs::path next = fs::read_symlink(out, error);
    if (error) break;
    out = out.parent_path() / next;  // an absolute link replaces everything before it
  }
  return out.string();
}

std::string folderOf(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// Returns an empty string, or why it failed.
std::string writeAll(int file, std::string_view bytes) {
  constexpr int kMostIdle = 1000;
  for (int idle = 0; !bytes.empty();) {
    const ssize_t written =
        uninterrupted([&] { return ::write(file, bytes.data(), bytes.size()); });
    if (written < 0) return std::strerror(errno);
    if (written == 0 && ++idle == kMostIdle) return "it accepts no more data";
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

/// Returns an empty string, or why the bytes may not be on the disk. Some file systems cannot tell.
std::string syncAll(int file) {
  if (uninterrupted([&] { return fsync(file); }) == 0) return {};
  const bool isUnknown = errno == EINVAL || errno == ENOSYS || errno == ENOTSUP || errno == EROFS;
  return isUnknown ? "" : std::strerror(errno);
}

/// Returns an empty string, or why it failed. The file is closed in any case, so it must not be
/// closed again.
std::string closed(int file) {
  return close(file) == 0 || errno == EINTR ? "" : std::strerror(errno);
}

bool removed(const std::string& path) {
  constexpr int kTries = 2;
  for (int i = 0; i < kTries; ++i)
    if (unlink(path.c_str()) == 0 || errno == ENOENT) return true;
  return false;
}

/// Copies owner (if allowed) and permissions of the file that will be replaced.
void takeOver(int file, const std::string& replaced) {
  struct stat old {};
  if (stat(replaced.c_str(), &old) != 0) return;
  const bool isMine = uninterrupted([&] { return fchown(file, old.st_uid, old.st_gid); }) == 0;
  // A set-user-id bit must not move to another owner.
  uninterrupted([&] { return fchmod(file, old.st_mode & (isMine ? 07777 : 0777)); });
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : name_(outputName(path)) {
  isDirect_ = isStandardOutput(path);
  if (isDirect_) return;
  struct stat info {};
  // A pipe reached through /dev/fd has no path of its own.
  isDirect_ = stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode);
  target_ = isDirect_ ? path : resolved(path);
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  removed(temporary_);
  keepOnSignal(temporary_);
}

Status OutputFile::failure(const std::string& reason) const {
  return {StatusCode::CannotWrite, "cannot write " + name_ + ": " + reason};
}

Status OutputFile::check() const {
  if (target_.empty()) return {};
  const std::string folder = folderOf(target_);
  std::error_code ignored;  // what cannot be looked up does not exist
  if (fs::is_directory(target_, ignored)) return failure("it is a folder. Name a file in it");
  if (!isDirect_ && fs::is_symlink(target_, ignored)) return failure(std::strerror(ELOOP));
  if (!fs::is_directory(folder, ignored))
    return failure(fs::exists(folder, ignored) ? folder + " is not a folder"
                                               : "there is no folder " + folder);
  if (access(target_.c_str(), F_OK) == 0 && access(target_.c_str(), W_OK) != 0)
    return failure(std::strerror(errno));
  if (!isDirect_ && access(folder.c_str(), W_OK | X_OK) != 0)
    return failure(std::string(std::strerror(errno)) + " in folder " + folder);
  return {};
}

/// Calls `call` with one path after another in the target's folder until it finds one that is not
/// taken. Returns an empty string, with errno set, if the call fails for another reason.
template <class Call>
std::string OutputFile::withFreshName(const Call& call) const {
  for (int i = 0; i < kMostNames; ++i) {
    const std::string name =
        ".abflat-" + std::to_string(getpid()) + "-" + std::to_string(i) + ".tmp";
    std::string path = (fs::path(folderOf(target_)) / name).string();
    if (uninterrupted([&] { return call(path.c_str()); }) >= 0) return path;
    if (errno != EEXIST) break;
  }
  return {};
}

/// Returns -1 and sets errno on failure. Does not use mkstemp, so that a new file gets the
/// permissions that umask asks for.
int OutputFile::openTemporary() {
  const SignalPause pause;
  int file = -1;
  temporary_ = withFreshName([&](const char* path) {
    return file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  });
  if (!temporary_.empty()) removeOnSignal(temporary_);
  return file;
}

Status OutputFile::write(std::string bytes) {
  if (isDirect_) {
    bytes_ = std::move(bytes);
    return {};
  }
  if (Status s = check(); !s.ok()) return s;
  const int file = openTemporary();
  if (file < 0) return failure(std::strerror(errno));
  takeOver(file, target_);
  std::string problem = writeAll(file, bytes);
  if (problem.empty()) problem = syncAll(file);
  const std::string atEnd = closed(file);
  if (problem.empty()) problem = atEnd;
  return problem.empty() ? Status{} : failure(problem);
}

Status OutputFile::writeDirectly() const {
  const int file = target_.empty()
                       ? STDOUT_FILENO
                       : uninterrupted([&] { return open(target_.c_str(), O_WRONLY | O_CLOEXEC); });
  if (file < 0) return failure(std::strerror(errno));
  std::string problem = writeAll(file, bytes_);
  if (file != STDOUT_FILENO) {
    const std::string atEnd = closed(file);
    if (problem.empty()) problem = atEnd;
  }
  return problem.empty() ? Status{} : failure(problem);
}

/// Gives the file that will be replaced a second name or, if the file system has no hard links, a
/// different name.
Status OutputFile::keepOld() {
  struct stat info {};
  if (lstat(target_.c_str(), &info) != 0) return {};
  const char* const from = target_.c_str();
  old_ = withFreshName([&](const char* path) { return link(from, path); });
  isOldInPlace_ = !old_.empty();
  if (isOldInPlace_) return {};
  old_ = withFreshName([&](const char* path) {
    errno = EEXIST;
    return lstat(path, &info) == 0 ? -1 : std::rename(from, path);
  });
  return old_.empty() ? failure(std::strerror(errno)) : Status{};
}

Status OutputFile::takeName() {
  if (Status s = keepOld(); !s.ok()) return s;
  const auto from = temporary_.c_str(), to = target_.c_str();
  if (uninterrupted([&] { return std::rename(from, to); }) != 0)
    return failure(std::strerror(errno));
  hasName_ = true;
  isOldInPlace_ = false;
  keepOnSignal(temporary_);
  temporary_.clear();
  return {};
}

/// Makes sure that names are on the disk, too.
Status OutputFile::syncFolder() const {
  const std::string folder = folderOf(target_);
  const int file = uninterrupted([&] { return open(folder.c_str(), O_RDONLY | O_CLOEXEC); });
  if (file < 0) return {};  // a folder that can be written to, but not read
  const std::string problem = syncAll(file);
  close(file);  // nothing was written through it
  return problem.empty() ? Status{} : failure(problem);
}

/// Restores everything to its old name.
Status OutputFile::undo() {
  if (isOldInPlace_) return removed(old_) ? Status{} : failure(std::strerror(errno));
  if (old_.empty()) return !hasName_ || removed(target_) ? Status{} : failure(std::strerror(errno));
  const auto from = old_.c_str(), to = target_.c_str();
  if (uninterrupted([&] { return std::rename(from, to); }) == 0) return {};
  return failure(std::string(std::strerror(errno)) + "; its previous content is in '" + old_ + "'");
}

void OutputFile::settle() {
  if (!old_.empty()) removed(old_);
  old_.clear();
}

Status OutputFile::takeNames(const std::vector<OutputFile*>& files) {
  const SignalPause pause;
  Status out;
  for (OutputFile* file : files) {
    if (file->temporary_.empty()) continue;
    out = pause.hasSignal() ? file->failure("interrupted") : file->takeName();
    if (!out.ok()) break;
  }
  for (const OutputFile* file : files)
    if (out.ok() && file->hasName_) out = file->syncFolder();
  for (auto file = files.rbegin(); file != files.rend() && !out.ok(); ++file)
    if (Status s = (*file)->undo(); !s.ok()) out.message += "; " + s.message;
  if (out.ok())
    for (OutputFile* file : files) file->settle();
  return out;
}

Status OutputFile::commit(const std::vector<OutputFile*>& files) {
  for (const OutputFile* file : files)
    if (file->isDirect_)
      if (Status s = file->writeDirectly(); !s.ok()) return s;
  return takeNames(files);
}

Status OutputFile::writeNow(std::string bytes) {
  const Status written = write(std::move(bytes));
  return written.ok() ? commit({this}) : written;
}

}  // namespace abflat::cli
