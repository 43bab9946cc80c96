#pragma once

#include <optional>
#include <string>
#include <vector>

namespace abflat::cli {

/// What became of a mesh; its names are the words of the manifest.
enum class MeshStatus {
  Done,
  NotValid,
  Usage,
  Unreadable,
  NotFlattenable,
  CannotWrite,
  OutOfMemory,
  TimeLimit,
  MemoryLimit,
  Crashed
};

const char* wordFor(MeshStatus status);

/// A file of a result: its path below the folder of results, and its content.
struct WrittenFile {
  std::string path, hash;
};

/// What a manifest says about one mesh, or about the meshes of an atlas.
struct ManifestLine {
  std::string name;                 ///< as Task
  std::vector<std::string> inputs;  ///< paths of the meshes
  MeshStatus status = MeshStatus::Done;
  std::string message;                          ///< why it is not done
  std::string inputHash, optionsHash, version;  ///< what the result depends on
  std::vector<WrittenFile> files;               ///< each mesh, then what it needs
  std::string layout;                           ///< picture; empty: none
  std::string summary;                          ///< of the report, as JSON; empty: none
  double limit = 0;                             ///< what it has hit, seconds or MB; 0: none
  double seconds = 0, peakMemory = 0;
  bool isAtlas = false;

  bool isGood() const { return status == MeshStatus::Done; }
};

/// A line of JSON, with its end.
std::string manifestText(const ManifestLine& line);

/// None if the text is not such a line.
std::optional<ManifestLine> parseManifestLine(const std::string& text);

}  // namespace abflat::cli
