#include "arguments/baking.h"

#include "arguments/options.h"
#include "files/file_format.h"
#include "files/paths.h"

namespace abflat::cli {

void addBaking(CLI::App& app, Baking& baking) {
  CLI::Option* const bake =
      app.add_flag("--bake", baking.isWanted,
                   wrapped("have the textures of a glTF or an OBJ follow the new layout: its "
                           "materials get new images in place of the old ones"));
  constexpr int kOfLayout = 2;  // padding and threads, which come last
  for (int i = 0; i + kOfLayout < optionInfos(baking.options).count; ++i)
    addOption(app, baking.options, i)->needs(bake);
}

void checkBaking(const Baking& baking, const std::string& output, bool hasTiles) {
  if (!baking.isWanted) return;
  checkHoldsImages(output);
  if (hasTiles)
    throw CLI::ValidationError("--bake", "makes images of one tile, so it does not go with --udim");
}

void checkHoldsImages(const std::string& output) {
  const FileFormat format = writtenFormat(output);
  if (format == FileFormat::Obj && isStandardOutput(output))
    throw CLI::ValidationError("--output", "must be a file: the new images are written beside it");
  if (format != FileFormat::Gltf && format != FileFormat::Obj)
    throw CLI::ValidationError(
        "--output",
        "must end in .glb, .gltf or .obj: no other format holds new images. This is " + output);
}

}  // namespace abflat::cli
