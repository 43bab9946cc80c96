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

constexpr std::size_t kChunk = 1 << 20;

/// Empty, or why it failed.
std::string readAll(int file, std::string& bytes) {
  struct stat info {};
  if (fstat(file, &info) == 0) {
    if (S_ISDIR(info.st_mode)) return "it is a folder";
    if (S_ISREG(info.st_mode)) bytes.reserve(static_cast<std::size_t>(info.st_size) + kChunk);
  }
  for (std::size_t size = 0;;) {
    bytes.resize(size + kChunk);
    const ssize_t got = ::read(file, &bytes[size], kChunk);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::strerror(errno);
    size += static_cast<std::size_t>(got);
    bytes.resize(size);
    if (got == 0) return {};
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
