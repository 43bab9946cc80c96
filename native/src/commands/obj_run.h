#pragma once

#include <optional>
#include <string>
#include <vector>

#include "baking/bake_obj.h"
#include "files/files_beside.h"
#include "files/input_file.h"

namespace abflat::cli {

/// Bakes an OBJ: into files beside the new one, or into a glTF that is made from it. A PLY becomes
/// such a glTF, too.
class ObjRun {
 public:
  /// `others` are paths that the command writes besides, or reads.
  ObjRun(const std::string& output, const BakeOptionValues& options,
         std::vector<std::string> others);

  /// Done before the work, so that an image that is no image, or a name that is taken, costs no
  /// time. Errors: those of readOldObj, InvalidOption, CannotWrite.
  Status read(const InputFile& input);

  /// To be called once, with turned faces. The look of the input is that of a glTF made from it.
  Status bake(InputFile& input, const NewLayout& layout,
              const std::vector<std::uint32_t>& triangleCorners);

  const BakingReport& report() const { return new_.report; }
  /// Known once it is baked.
  const std::vector<std::string>& notes() const { return new_.notes; }
  /// What cannot be kept, known from `read` on.
  const std::vector<std::string>& leftOut() const { return old_->maps.notes; }

  /// The text of the new OBJ, with the name of its material file if there is one.
  std::string named(std::string obj) const;
  /// As FilesBeside.
  Status write(std::vector<OutputFile*>& files);

 private:
  Status bakeBeside(ObjBaker& baker);
  std::vector<std::string> names() const;
  bool isEmpty() const { return old_->plans.plans.empty(); }
  void noteDepth();
  bool isBeside() const { return !isGltf_ && !isEmpty(); }

  FilesBeside beside_;
  bool isGltf_;
  BakeOptionValues options_;
  std::vector<std::string> others_;
  std::optional<OldObj> old_;
  NewObj new_;
};

}  // namespace abflat::cli
