#include "commands/look_obj_run.h"

#include <filesystem>
#include <utility>

#include "files/out_of_memory.h"
#include "files/paths.h"

namespace abflat::cli {

Status LookObjRun::read(const InputFile& input, std::vector<std::string> others) {
  const std::filesystem::path folder = std::filesystem::path(input.path).parent_path();
  const ReadResource readResource = [&](const std::string& name) {
    others.push_back((folder / name).string());
    return input.readResource(name);
  };
  Result<OldLook> look =
      orOutOfMemory(inputName(input.path), [&] { return readOldLook(*input.gltf, readResource); });
  if (!look.ok()) return look.status();
  old_ = std::move(look).value();
  std::vector<std::string> names = lookOfObjNames(beside_.stem(), options_.imageFormat);
  names.push_back(library());
  return beside_.check(names, others);
}

Status LookObjRun::bake(const PolygonMesh& mesh, const NewLayout& layout) {
  Result<LookOfObj> look =
      bakeLookOfObj(old_, layout, options_, beside_.stem(), mesh.materialNames);
  if (!look.ok()) return look.status();
  new_ = std::move(look).value();
  return {};
}

std::string LookObjRun::text(const PolygonMesh& mesh, const NewLayout& layout) const {
  return makeObj(mesh, layout.uv, layout.ofCorner, library(), new_.materials);
}

Status LookObjRun::write(std::vector<OutputFile*>& files) {
  std::vector<ImageFile> contents = std::move(new_.images);
  contents.push_back({library(), {}, makeMtl(new_.materials)});
  return beside_.write(std::move(contents), files);
}

}  // namespace abflat::cli
