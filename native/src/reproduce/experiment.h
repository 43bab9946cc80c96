#pragma once

#include <map>
#include <string>
#include <vector>

#include "abflat/flatten.h"
#include "reproduce/paper_numbers.h"

namespace abflat::cli {

/// One mesh to experiment on, read only when its turn comes.
struct Model {
  std::string name;         ///< display name, unique
  std::string fileStem;     ///< for file names; unique; letters, digits, dots and dashes
  std::string path;         ///< empty: a generated sample
  std::string_view sample;  ///< its name; empty: a file
  const PaperModel* paper = nullptr;
};

/// The generated models that look like those of the paper, then the meshes of a folder, by name;
/// an empty `folder` adds none. Errors: UnreadableFile.
Result<std::vector<Model>> findModels(const std::string& folder);

/// Seconds from input arrays to output arrays, counted as in `sweep`.
double secondsOf(const Report& report);

/// A mesh with its layouts, each computed when first asked for.
class Experiment {
 public:
  explicit Experiment(const Model& model);

  const Model& model() const { return model_; }
  /// Why nothing can be done with the mesh: it cannot be read or is not a disk.
  const Status& status() const { return status_; }
  const PolygonMesh& mesh() const { return mesh_; }
  const MeshSummary& summary() const { return summary_; }

  const Result<FlattenResult>& flattened(double t);
  Result<FlattenResult> flattenedWith(const FlattenOptions& options) const;

 private:
  const Model& model_;
  PolygonMesh mesh_;
  MeshSummary summary_;
  Status status_;
  std::map<double, Result<FlattenResult>> results_;
};

}  // namespace abflat::cli
