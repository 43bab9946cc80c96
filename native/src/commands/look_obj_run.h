#pragma once

#include <string>
#include <vector>

#include "baking/bake_look.h"
#include "baking/bake_look_obj.h"
#include "files/files_beside.h"
#include "files/input_file.h"

namespace abflat::cli {

/// Bakes a glTF into an OBJ, with its materials and images as files beside it.
class LookObjRun {
 public:
  LookObjRun(const std::string& output, const BakeOptionValues& options)
      : beside_(output), options_(options) {}

  /// Done before the work. `others` are paths that the command writes besides, or reads. Errors:
  /// those of readOldLook, InvalidOption, CannotWrite.
  Status read(const InputFile& input, std::vector<std::string> others);

  /// To be called once, with turned faces.
  Status bake(const PolygonMesh& mesh, const NewLayout& layout);

  const BakingReport& report() const { return new_.report; }
  const std::vector<std::string>& notes() const { return new_.notes; }

  /// The text of the OBJ.
  std::string text(const PolygonMesh& mesh, const NewLayout& layout) const;
  /// As FilesBeside.
  Status write(std::vector<OutputFile*>& files);

 private:
  std::string library() const { return beside_.stem() + ".mtl"; }

  FilesBeside beside_;
  BakeOptionValues options_;
  OldLook old_;
  LookOfObj new_;
};

}  // namespace abflat::cli
