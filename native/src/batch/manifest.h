#pragma once

#include <map>
#include <set>
#include <string>

#include "abflat/status.h"
#include "batch/manifest_line.h"

namespace abflat::cli {

/// The lines of a manifest by name; of several with one name, the last.
using ManifestLines = std::map<std::string, ManifestLine>;

/// Lines that are not complete, as a run that was killed may leave the last one, are left out.
/// Errors: UnreadableFile.
Result<ManifestLines> readManifest(const std::string& path);

/// A manifest that is being written. Only one program at a time can have it.
class Manifest {
 public:
  explicit Manifest(std::string path) : path_(std::move(path)) {}
  ~Manifest();
  Manifest(const Manifest&) = delete;
  Manifest& operator=(const Manifest&) = delete;

  /// Opens the file, which is created if it is missing. Errors: CannotWrite, also if another
  /// program has it.
  Status open();
  bool isNew() const { return isNew_; }
  const ManifestLines& lines() const { return lines_; }

  /// Adds or replaces a line, on the disk as well. Errors: CannotWrite.
  Status add(ManifestLine line);
  /// Forgets what is not in `names`; on the disk once it is sorted.
  void keepOnly(const std::set<std::string>& names);
  /// Writes the file anew: sorted, with one line for each name. Errors: CannotWrite.
  Status sort();

 private:
  Status failure() const;
  Status endTornLine() const;

  const std::string path_;
  int file_ = -1;
  bool isNew_ = false;
  ManifestLines lines_;
};

/// "manifest.jsonl", or that of a part: "manifest-0-of-4.jsonl".
std::string manifestName(std::size_t shard, std::size_t shards);

}  // namespace abflat::cli
