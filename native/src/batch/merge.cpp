#include "batch/merge.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "files/output_file.h"

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

/// Numbers of parts that have a manifest, by how many parts there are.
std::map<std::size_t, std::set<std::size_t>> partsIn(const std::string& out) {
  std::map<std::size_t, std::set<std::size_t>> parts;
  std::error_code ignored;  // then there are none
  for (const fs::directory_entry& entry : fs::directory_iterator(out, ignored)) {
    std::size_t shard = 0, shards = 0;
    const std::string name = entry.path().filename().string();
    if (std::sscanf(name.c_str(), "manifest-%zu-of-%zu.jsonl", &shard, &shards) == 2 &&
        name == manifestName(shard, shards) && shard < shards)
      parts[shards].insert(shard);
  }
  return parts;
}

}  // namespace

Result<ManifestLines> mergeManifests(const std::string& out) {
  const auto parts = partsIn(out);
  if (parts.empty())
    return Status{StatusCode::UnreadableFile, out + " has no manifests of parts to merge"};
  if (parts.size() > 1)
    return Status{StatusCode::InvalidOption,
                  out + " has manifests of " + std::to_string(parts.begin()->first) +
                      " parts and of " + std::to_string(parts.rbegin()->first) +
                      ". Remove those that do not count"};
  const auto& [shards, found] = *parts.begin();
  std::string text;
  ManifestLines all;
  for (std::size_t shard = 0; shard < shards; ++shard) {
    const std::string path = (fs::path(out) / manifestName(shard, shards)).string();
    if (found.count(shard) == 0)
      return Status{StatusCode::UnreadableFile, path + " is missing. Run --shard " +
                                                    std::to_string(shard) + "/" +
                                                    std::to_string(shards) + " first"};
    Result<ManifestLines> lines = readManifest(path);
    if (!lines.ok()) return lines.status();
    all.merge(lines.value());
    if (!lines.value().empty())
      return Status{StatusCode::InvalidOption,
                    lines.value().begin()->first +
                        " is in two parts, so it has changed since. Run all parts again with "
                        "--resume"};
  }
  for (const auto& [name, line] : all) text += manifestText(line);
  const std::string path = (fs::path(out) / manifestName(0, 1)).string();
  if (Status s = OutputFile(path).writeNow(std::move(text)); !s.ok()) return s;
  return all;
}

}  // namespace abflat::cli
