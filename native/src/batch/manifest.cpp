#include "batch/manifest.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iterator>
#include <sstream>
#include <string_view>

#include "files/output_file.h"
#include "files/read_file.h"
#include "files/system_call.h"

namespace abflat::cli {
namespace {

bool isSameFile(int file, const std::string& path) {
  struct stat open {
  }, named{};
  return fstat(file, &open) == 0 && stat(path.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

bool appended(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = uninterrupted([&] { return ::write(file, bytes.data(), bytes.size()); });
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

Result<ManifestLines> readManifest(const std::string& path) {
  const Result<std::string> text = readBytes(path);
  if (!text.ok()) return text.status();
  ManifestLines out;
  std::istringstream lines(text.value());
  for (std::string each; std::getline(lines, each);)
    if (std::optional<ManifestLine> line = parseManifestLine(each))
      out.insert_or_assign(line->name, *line);
  return out;
}

Manifest::~Manifest() {
  if (file_ >= 0) close(file_);  // each line has been flushed
}

Status Manifest::failure() const {
  return {StatusCode::CannotWrite, "cannot write " + path_ + ": " + std::strerror(errno)};
}

Status Manifest::open() {
  constexpr int kTries = 100;  // another run may put a new file there at any time
  for (int i = 0; i < kTries; ++i) {
    isNew_ = access(path_.c_str(), F_OK) != 0;
    file_ = uninterrupted(
        [&] { return ::open(path_.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, 0666); });
    if (file_ < 0) return failure();
    // Some network file systems have no locks.
    if (flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      return {StatusCode::CannotWrite,
              path_ + " is in use by another run. Wait for it, or give --out another folder"};
    if (isSameFile(file_, path_)) break;
    close(file_);
    file_ = -1;
  }
  if (file_ < 0) return failure();
  Result<ManifestLines> lines = readManifest(path_);
  if (!lines.ok()) return lines.status();
  lines_ = std::move(lines.value());
  return endTornLine();
}

/// So that the next line is one of its own.
Status Manifest::endTornLine() const {
  const off_t size = lseek(file_, 0, SEEK_END);
  char last = '\n';
  if (size > 0 && pread(file_, &last, 1, size - 1) != 1) return failure();
  if (last != '\n' && !appended(file_, "\n")) return failure();
  return {};
}

Status Manifest::add(ManifestLine line) {
  if (!appended(file_, manifestText(line)) || fsync(file_) != 0) return failure();
  std::string name = line.name;
  lines_.insert_or_assign(std::move(name), std::move(line));
  return {};
}

void Manifest::keepOnly(const std::set<std::string>& names) {
  for (auto line = lines_.begin(); line != lines_.end();)
    line = names.count(line->first) > 0 ? std::next(line) : lines_.erase(line);
}

Status Manifest::sort() {
  std::string text;
  for (const auto& [name, line] : lines_) text += manifestText(line);
  return OutputFile(path_).writeNow(std::move(text));
}

std::string manifestName(std::size_t shard, std::size_t shards) {
  if (shards <= 1) return "manifest.jsonl";
  return "manifest-" + std::to_string(shard) + "-of-" + std::to_string(shards) + ".jsonl";
}

}  // namespace abflat::cli
