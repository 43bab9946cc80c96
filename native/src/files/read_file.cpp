#include "files/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>

#include "files/paths.h"
#include "files/system_call.h"

namespace abflat::cli {
namespace {

/// Space beyond the size that a file claims: enough to detect its end, and to start with if it
/// claims no size.
constexpr std::size_t kSpare = 1 << 12;

/// A sparse file takes no room on the disk, but it would here.
constexpr off_t kMostOrdinary = off_t{1} << 32;

Status failure(const std::string& path, const std::string& reason) {
  return {StatusCode::UnreadableFile, "cannot read " + inputName(path) + ": " + reason};
}

bool isNull(const struct stat& info) {
  struct stat null {};
  return stat("/dev/null", &null) == 0 && null.st_rdev == info.st_rdev;
}

/// Why nothing can be read to its end there; empty if it can.
std::string problemOf(const struct stat& info, int file) {
  if (S_ISDIR(info.st_mode)) return "it is a folder";
  if (S_ISBLK(info.st_mode)) return "it is a device";
  if (S_ISCHR(info.st_mode) && isatty(file) == 0 && !isNull(info)) return "it is a device";
  return {};
}

std::string problemOfOrdinary(const struct stat& info) {
  if (S_ISDIR(info.st_mode)) return "it is a folder";
  if (!S_ISREG(info.st_mode)) return "it is a device or a pipe";
  return info.st_size > kMostOrdinary ? "it is larger than 4 GB" : "";
}

/// Reads until the end. Returns an empty string, or why it failed.
std::string readToEnd(int file, std::size_t claimed, std::string& bytes) {
  bytes.resize(claimed + kSpare);
  for (std::size_t size = 0;;) {
    if (size == bytes.size()) bytes.resize(2 * size);
    const ssize_t got =
        uninterrupted([&] { return ::read(file, &bytes[size], bytes.size() - size); });
    if (got < 0) return std::strerror(errno);
    size += static_cast<std::size_t>(got);
    if (got > 0) continue;
    bytes.resize(size);
    return {};
  }
}

/// Reads no more than `size` bytes.
std::string readUpTo(int file, std::size_t size, std::string& bytes) {
  bytes.resize(size);
  for (std::size_t done = 0; done < size;) {
    const ssize_t got = uninterrupted([&] { return ::read(file, &bytes[done], size - done); });
    if (got < 0) return std::strerror(errno);
    if (got == 0) bytes.resize(done);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return {};
}

}  // namespace

Result<std::string> readBytes(const std::string& path) {
  const bool isStandard = path == kStandardStream;
  const int file = isStandard
                       ? STDIN_FILENO
                       : uninterrupted([&] { return open(path.c_str(), O_RDONLY | O_CLOEXEC); });
  if (file < 0) return failure(path, std::strerror(errno));
  std::string bytes, problem;
  struct stat info {};
  if (fstat(file, &info) != 0)
    problem = std::strerror(errno);
  else
    problem = problemOf(info, file);
  const std::size_t claimed = S_ISREG(info.st_mode) ? static_cast<std::size_t>(info.st_size) : 0;
  if (problem.empty()) problem = readToEnd(file, claimed, bytes);
  if (!isStandard) close(file);  // nothing was written, so nothing can be lost
  if (!problem.empty()) return failure(path, problem);
  return bytes;
}

std::string readOrdinaryFile(const std::string& path, std::string& bytes) {
  struct stat info {};
  if (lstat(path.c_str(), &info) != 0) return std::strerror(errno);
  // Opening alone may have effects: rewind a tape, or wait for a pipe.
  if (std::string s = problemOfOrdinary(info); !s.empty()) return s;
  const int file = uninterrupted([&] {
    return open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY);
  });
  if (file < 0) return std::strerror(errno);
  std::string problem =
      fstat(file, &info) == 0 ? problemOfOrdinary(info) : std::string(std::strerror(errno));
  if (problem.empty()) problem = readUpTo(file, static_cast<std::size_t>(info.st_size), bytes);
  close(file);  // nothing was written, so nothing can be lost
  return problem;
}

}  // namespace abflat::cli
