#include "input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "arguments.h"
#include "out_of_memory.h"
#include "paths.h"

namespace abflat::cli {
namespace {

/// Beyond the size that a file claims: enough to see its end, and to begin with where it claims
/// none.
constexpr std::size_t kSpare = 1 << 12;

/// Empty, or why it failed.
std::string readAll(int file, std::string& bytes) {
  struct stat info {};
  std::size_t claimed = 0;
  if (fstat(file, &info) == 0) {
    if (S_ISDIR(info.st_mode)) return "it is a folder";
    if (S_ISREG(info.st_mode)) claimed = static_cast<std::size_t>(info.st_size);
  }
  bytes.resize(claimed + kSpare);
  for (std::size_t size = 0;;) {
    if (size == bytes.size()) bytes.resize(2 * size);
    const ssize_t got = ::read(file, &bytes[size], bytes.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::strerror(errno);
    size += static_cast<std::size_t>(got);
    if (got > 0) continue;
    bytes.resize(size);
    return {};
  }
}

}  // namespace

Result<std::string> readBytes(const std::string& path) {
  const bool isStandard = path == kStandardStream;
  const auto failure = [&](const std::string& reason) {
    return Status{StatusCode::UnreadableFile, "cannot read " + inputName(path) + ": " + reason};
  };
  const int file = isStandard ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return failure(std::strerror(errno));
  std::string bytes;
  const std::string problem = readAll(file, bytes);
  if (!isStandard) close(file);  // nothing was written, so nothing can get lost
  if (!problem.empty()) return failure(problem);
  return bytes;
}
Result<InputMesh> readInput(const std::string& path) {
  return orOutOfMemory(inputName(path), [&]() -> Result<InputMesh> {
    InputMesh out;
    Result<std::string> bytes = readBytes(path);
    if (!bytes.ok()) return bytes.status;
    out.bytes = std::move(bytes.value);
    const Result<MeshFormat> format = detectFormat(inputName(path), out.bytes);
    if (!format.ok()) return format.status;
    out.format = format.value;
    Result<PolygonMesh> mesh = readMesh(out.bytes, out.format, inputName(path));
    if (!mesh.ok()) return mesh.status;
    out.mesh = std::move(mesh.value);
    return out;
  });
}

}  // namespace abflat::cli
